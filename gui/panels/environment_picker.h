// EnvironmentPicker: thumbnails of the environments that come with the program and any other
// picture, and the environment's settings below.
#pragma once

#include <QWidget>
#include <filesystem>

class QListWidget;
class QListWidgetItem;

namespace glint {

class Document;

class EnvironmentPicker : public QWidget {
    Q_OBJECT

  public:
    /// `folder` holds the environments that come with the program.
    EnvironmentPicker(Document& document, const std::filesystem::path& folder,
                      QWidget* parent = nullptr);

    /// Makes a picture file the environment.
    void choose(const std::filesystem::path& image);
    void chooseNone();
    /// Asks for a picture file.
    void browse();
    [[nodiscard]] QListWidget* thumbnails() const { return thumbnails_; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void buildThumbnails();
    void addThumbnail(const std::filesystem::path& image);
    /// Has the pictures read whose thumbnails nobody has asked for yet: only when the panel is
    /// seen, since a large one takes tenths of a second of a processor. (A tab that is not the
    /// current one is shown too, for a moment, but never painted.)
    void requestThumbnails();
    void chooseSky();
    void showCurrent();
    [[nodiscard]] QListWidgetItem* itemFor(const std::filesystem::path& image) const;

    Document& document_;
    QListWidget* thumbnails_;
};

}  // namespace glint
