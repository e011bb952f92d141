// FileController: new, open, save, recent files. Files are read on a background thread; a broken
// one never replaces the scene that is there. What is to be said goes to the message bar; only
// unsaved changes ask.
#pragma once

#include <QObject>
#include <QStringList>
#include <QThreadPool>
#include <filesystem>
#include <functional>

#include "gui/app/file_reading.h"
#include "gui/app/memory.h"

namespace glint {

class Document;
class MessageBar;

class FileController : public QObject {
    Q_OBJECT

  public:
    FileController(Document& document, MessageBar& messages, Memory memory, QWidget* window);

    void newScene();
    /// Asks about unsaved changes, then starts an untitled scene as a copy of that file.
    void newFrom(const std::filesystem::path& file);
    void browse();
    /// Asks about unsaved changes, then opens.
    void open(const std::filesystem::path& file);
    /// Opens without asking; the scene there is replaced when the file has been read, at once if it
    /// has been.
    void load(FileReading reading);
    void load(const std::filesystem::path& file) { load(readInBackground(file)); }
    void save() { saveThen({}); }
    void saveAs() { saveAsThen({}); }
    /// Saves there now; false, with a message, if that fails.
    bool saveTo(const std::filesystem::path& file);
    /// Runs `then` when no unsaved change can be lost: at once, or after the person chose to save
    /// or discard.
    void whenSafe(std::function<void()> then);
    [[nodiscard]] const QStringList& recent() const { return recent_; }

  signals:
    void recentChanged();
    /// The document now stands in its file.
    void saved();

  private:
    void saveThen(std::function<void()> then);
    void saveAsThen(std::function<void()> then);
    void remember(const std::filesystem::path& file);

    Document& document_;
    MessageBar& messages_;
    Memory memory_;
    QWidget* window_;
    QStringList recent_;
    QThreadPool settingsWriter_;  ///< one thread: the newest list is written last
    int loads_ = 0;               ///< a newer load makes an older one void
};

/// What an empty window starts with: a floor, a ball, a light.
struct Scene;
[[nodiscard]] Scene starterScene();

}  // namespace glint
