// FileWatch: notices when another program changes the pictures and models of the scene, or its
// file.
#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QStringList>
#include <QTimer>
#include <filesystem>
#include <map>
#include <optional>

namespace glint {

class Document;

class FileWatch : public QObject {
    Q_OBJECT

  public:
    explicit FileWatch(const Document& document, QObject* parent = nullptr);

    /// The scene's file as it is now is the document's: just opened or saved.
    void noteSceneFile();

  signals:
    /// Pictures or models are other than before: the scene is to be compiled again.
    void assetsChanged(const QStringList& files);
    /// The scene's file is other than the one that was opened or saved last.
    void sceneFileChanged();

  private:
    using Time = std::optional<std::filesystem::file_time_type>;  ///< none: there is no such file

    void updateList();
    void check();

    const Document& document_;
    QFileSystemWatcher watcher_;
    /// Programs write in several steps, and edits come in bursts: both are looked at when they have
    /// been quiet for a while.
    QTimer listTimer_, checkTimer_;
    std::map<std::filesystem::path, Time> assets_;
    Time sceneTime_;
};

}  // namespace glint
