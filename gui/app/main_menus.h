// MainMenus: the window's menu bar, the menu that opens over the picture, and those that fill
// themselves when they open.
#pragma once

#include <QObject>
#include <QPointF>

class QMainWindow;
class QMenu;

namespace glint {

class Actions;
class Document;
class EditController;
class FileController;
class ObjectList;
class RenderView;
class ViewCommands;

class MainMenus : public QObject {
    Q_OBJECT

  public:
    struct Parts {
        Actions& actions;
        const Document& document;
        FileController& files;
        EditController& edits;
        ViewCommands& views;
        RenderView& picture;
        ObjectList& objects;
    };
    /// Makes the menus of `window`, which must have its docks; they go with this object but for the
    /// bar, which is the window's.
    MainMenus(const Parts& parts, QMainWindow& window);

  private:
    QMenu* addMenu(const QString& title, std::initializer_list<const char*> ids);
    void buildFileMenu();
    void buildAddMenu();
    void buildViewMenu();
    void buildRenderMenu();
    void buildWindowMenu();
    void buildContextMenu();
    void openAddMenu();
    void openContextMenu(const QPoint& at);
    void fillRecent(QMenu* menu);
    void fillCameras(QMenu* menu);
    void fillSavedViews(QMenu* menu);

    Parts parts_;
    QMainWindow& window_;
    QMenu* add_ = nullptr;
    QMenu* context_ = nullptr;
    QPointF
        addAt_;  ///< where new things stand, in the picture's logical pixels; null: in its middle
};

}  // namespace glint
