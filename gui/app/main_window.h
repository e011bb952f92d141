// MainWindow: puts the parts together: document, renderer, viewport, docks, menus. What commands do
// is in the controllers; here is which action calls which of them.
#pragma once

#include <QMainWindow>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "gui/app/document.h"
#include "gui/app/file_reading.h"
#include "gui/app/memory.h"
#include "gui/app/preferences.h"
#include "gui/app/selection.h"

class QStackedWidget;

namespace glint {

class Actions;
class Autosave;
class CommandSearch;
class EditController;
class EnvironmentPicker;
class ExportQueue;
class FileController;
class MaterialPanel;
class MaterialPreviews;
class FileWatch;
class LazyDock;
class MainMenus;
class MessageBar;
class MessageLog;
class NarrowLayout;
class ObjectList;
class PreviewRenderer;
class PixelInspector;
class PropertyPanel;
class Renderer;
class RenderView;
class SceneThumbnails;
class StatusLine;
class ViewCommands;

class MainWindow : public QMainWindow {
    Q_OBJECT

  public:
    /// Opens `scene` once it has been read.
    explicit MainWindow(Memory memory, std::optional<FileReading> scene = {},
                        QWidget* parent = nullptr);
    ~MainWindow() override;

    [[nodiscard]] Document& document() { return document_; }
    [[nodiscard]] Selection& selection() { return selection_; }
    [[nodiscard]] Preferences& preferences() { return preferences_; }
    [[nodiscard]] Renderer& renderer() { return *renderer_; }
    [[nodiscard]] RenderView& view() { return *view_; }
    [[nodiscard]] ObjectList& objectList() { return *objects_; }
    [[nodiscard]] PropertyPanel& properties() { return *properties_; }
    [[nodiscard]] EnvironmentPicker& environment();
    [[nodiscard]] MaterialPanel& materials() { return *materials_; }
    [[nodiscard]] MaterialPreviews& materialPreviews() { return *materialPreviews_; }
    [[nodiscard]] PixelInspector& inspector();
    [[nodiscard]] MessageBar& messages() { return *messages_; }
    [[nodiscard]] FileController& files() { return *files_; }
    [[nodiscard]] ExportQueue& exports() { return *exports_; }
    [[nodiscard]] StatusLine& status() { return *status_; }
    [[nodiscard]] Actions& actions() { return *actions_; }
    [[nodiscard]] Autosave& autosave() { return *autosave_; }
    /// Above the messages: what an earlier run left behind.
    [[nodiscard]] MessageBar& recoveryBar() { return *recoveryBar_; }

    /// Covers the picture with the start page until a scene is chosen.
    void showStartPage();
    /// A scene is opened, a picture becomes the environment.
    void openDropped(const std::filesystem::path& file);
    /// Asks about the unsaved work of runs that did not end properly, if there is any.
    void offerRecovery();

  protected:
    void changeEvent(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    void beginWith(FileReading scene);
    /// The first picture is on the screen: what had to wait for it may begin.
    void endStart();
    void buildCenter();
    /// Makes everything with words on it but the picture: actions, docks, menus, bars. All of it
    /// goes, and is made anew, when the language changes: connections from what stays must
    /// therefore have `actions_` as their context.
    void buildInterface();
    void removeInterface();
    void buildDocks();
    void connectFileActions();
    void connectState();
    void connectDisk();
    /// `make` builds the content when the dock is first seen or asked for.
    LazyDock* addDock(const QString& name, const QString& title, Qt::DockWidgetArea area,
                      std::function<QWidget*(QWidget* parent)> make);
    void updateTitle();
    void updateSelectionText();
    void openExport();
    void openPreferences();
    void hideStartPage();
    void applyPreferences(const PreferenceValues& before);

    Memory memory_;
    Preferences preferences_;
    Document document_;
    std::unique_ptr<Autosave> autosave_;
    Selection selection_;
    Renderer* renderer_;
    RenderView* view_ = nullptr;
    QStackedWidget* pages_ = nullptr;  ///< the view, and over it the start page
    MessageLog* log_ = nullptr;
    SceneThumbnails* thumbnails_ = nullptr;
    MessageBar* messages_ = nullptr;
    MessageBar* recoveryBar_ = nullptr;
    StatusLine* status_ = nullptr;
    ObjectList* objects_ = nullptr;
    PropertyPanel* properties_ = nullptr;
    LazyDock* environment_ = nullptr;
    MaterialPanel* materials_ = nullptr;
    PreviewRenderer* previews_ = nullptr;
    MaterialPreviews* materialPreviews_ = nullptr;
    LazyDock* inspector_ = nullptr;
    Actions* actions_ = nullptr;
    ViewCommands* viewCommands_ = nullptr;
    EditController* edits_ = nullptr;
    FileController* files_ = nullptr;
    FileWatch* fileWatch_ = nullptr;
    ExportQueue* exports_ = nullptr;
    CommandSearch* search_ = nullptr;
    MainMenus* menus_ = nullptr;
    NarrowLayout* narrow_ = nullptr;
    bool closing_ = false;
};

}  // namespace glint
