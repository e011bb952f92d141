// StartPage: what an empty start shows over the picture: templates, demos with thumbnails, recent
// files, "drop a file here".
#pragma once

#include <QFrame>
#include <QStringList>
#include <filesystem>
#include <vector>

class QListWidget;
class QVBoxLayout;

namespace glint {

class SceneThumbnails;

class StartPage : public QFrame {
    Q_OBJECT

  public:
    StartPage(SceneThumbnails& thumbnails, const QStringList& recent, QWidget* parent = nullptr);

  signals:
    /// A file is to be opened as it is.
    void openRequested(const std::filesystem::path& file);
    /// A new scene is to begin as a copy of this one.
    void templateRequested(const std::filesystem::path& file);
    void browseRequested();
    void closed();

  protected:
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void addHeader(QVBoxLayout* layout);
    void addFiles(QVBoxLayout* layout, const QString& title, const QString& name,
                  const std::vector<std::filesystem::path>& files,
                  void (StartPage::*signal)(const std::filesystem::path&));
    void addFooter(QVBoxLayout* layout);
    void showPicture(const std::filesystem::path& file, const QImage& picture);

    SceneThumbnails& thumbnails_;
    std::vector<QListWidget*> lists_;
};

/// Scene files of a folder, by name.
[[nodiscard]] std::vector<std::filesystem::path> sceneFiles(const std::filesystem::path& folder);
/// "still_life.json" as a person reads it: "Still life", in their language where it is a demo or
/// template.
[[nodiscard]] QString sceneTitle(const std::filesystem::path& file);

}  // namespace glint
