#include "gui/app/main_menus.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>

#include "gui/app/actions.h"
#include "gui/app/document.h"
#include "gui/app/edit_controller.h"
#include "gui/app/file_controller.h"
#include "gui/app/picture_controls.h"
#include "gui/app/resources.h"
#include "gui/app/text.h"
#include "gui/panels/object_list.h"
#include "gui/panels/start_page.h"
#include "gui/viewport/render_view.h"
#include "gui/viewport/view_commands.h"

namespace glint {

MainMenus::MainMenus(const Parts& parts, QMainWindow& window)
    : QObject(&window), parts_(parts), window_(window) {
    buildFileMenu();
    addMenu(tr("&Edit"), {"edit.undo",
                          "edit.redo",
                          "-",
                          "edit.cut",
                          "edit.copy",
                          "edit.paste",
                          "edit.duplicate",
                          "edit.delete",
                          "-",
                          "edit.selectAll",
                          "edit.selectNone",
                          "edit.rename",
                          "-",
                          "edit.hide",
                          "edit.hideRest",
                          "edit.showAll",
                          "-",
                          "edit.group",
                          "edit.ungroup",
                          "-",
                          "edit.preferences"});
    buildAddMenu();
    buildViewMenu();
    buildRenderMenu();
    buildWindowMenu();
    addMenu(tr("&Help"), {"help.shortcuts", "help.search", "-", "help.about"});
    buildContextMenu();
}

QMenu* MainMenus::addMenu(const QString& title, std::initializer_list<const char*> ids) {
    QMenu* menu = window_.menuBar()->addMenu(title);
    menu->setToolTipsVisible(true);
    parts_.actions.fill(menu, ids);
    return menu;
}

void MainMenus::buildFileMenu() {
    QMenu* file = addMenu(tr("&File"), {"file.new"});
    QMenu* templates = file->addMenu(tr("New from &template"));
    for (const auto& path : sceneFiles(templateFolder()))
        connect(templates->addAction(sceneTitle(path)), &QAction::triggered, this,
                [this, path] { parts_.files.newFrom(path); });
    parts_.actions.fill(file, {"file.startPage", "-", "file.open"});
    QMenu* recent = file->addMenu(tr("Open &recent"));
    connect(recent, &QMenu::aboutToShow, this, [this, recent] { fillRecent(recent); });
    parts_.actions.fill(file,
                        {"-", "file.save", "file.saveAs", "-", "file.export", "-", "file.quit"});
}

void MainMenus::buildAddMenu() {
    add_ = addMenu(tr("&Add"), {});
    parts_.edits.fillAddMenu(
        add_, [this] { return addAt_.isNull() ? QRectF(parts_.picture.rect()).center() : addAt_; });
    parts_.objects.setAddMenu(add_);
    parts_.actions.on("add.menu", this, &MainMenus::openAddMenu);
}

void MainMenus::buildViewMenu() {
    QMenu* view = addMenu(tr("&View"), {"tool.select",
                                        "tool.move",
                                        "tool.rotate",
                                        "tool.scale",
                                        "tool.snap",
                                        "-",
                                        "view.frameSelected",
                                        "view.frameAll",
                                        "-",
                                        "view.front",
                                        "view.behind",
                                        "view.right",
                                        "view.left",
                                        "view.top",
                                        "view.bottom",
                                        "-",
                                        "view.projection",
                                        "view.camera",
                                        "-",
                                        "view.previous",
                                        "view.next",
                                        "-",
                                        "view.overlay",
                                        "view.grid",
                                        "-",
                                        "view.filter",
                                        "view.darker",
                                        "view.brighter"});
    QMenu* cameras = view->addMenu(parts_.actions["view.camera"]->icon(), tr("Ca&meras"));
    cameras->setObjectName("cameras");
    connect(cameras, &QMenu::aboutToShow, this, [this, cameras] { fillCameras(cameras); });
    QMenu* saved = view->addMenu(tr("Sa&ved views"));
    connect(saved, &QMenu::aboutToShow, this, [this, saved] { fillSavedViews(saved); });
}

void MainMenus::buildRenderMenu() {
    QMenu* render = addMenu(tr("&Render"), {"render.pause", "-", "view.region", "view.regionClear",
                                            "view.isolate", "view.compare", "-", "render.inspect"});
    QMenu* channels = render->addMenu(tr("&Channel"));
    channels->setToolTipsVisible(true);
    for (const char* id : kChannelActions) channels->addAction(parts_.actions[id]);
    parts_.actions.fill(render,
                        {"-", "render.copy", "-", "render.errorReport", "-", "file.export"});
}

void MainMenus::buildWindowMenu() {
    QMenu* menu = addMenu(tr("&Window"), {});
    for (QDockWidget* dock : window_.findChildren<QDockWidget*>())
        menu->addAction(dock->toggleViewAction());
    parts_.actions.fill(menu, {"-", "window.light"});
}

void MainMenus::buildContextMenu() {
    context_ = new QMenu(&window_);
    connect(this, &QObject::destroyed, context_, &QObject::deleteLater);
    context_->addMenu(add_);
    parts_.actions.fill(
        context_, {"-", "edit.cut", "edit.copy", "edit.paste", "edit.duplicate", "edit.delete",
                   "edit.rename", "-", "edit.hide", "edit.hideRest", "edit.showAll", "edit.group",
                   "edit.ungroup", "-", "view.frameSelected", "view.frameAll", "-"});
    connect(context_->addAction(tr("&Inspect pixel")), &QAction::triggered, this,
            [this] { parts_.picture.inspect(addAt_); });
    connect(&parts_.picture, &RenderView::menuRequested, this, &MainMenus::openContextMenu);
    connect(&parts_.objects, &ObjectList::menuRequested, this, &MainMenus::openContextMenu);
}

void MainMenus::openAddMenu() {
    addAt_ = parts_.picture.pointerOrCenter();
    add_->popup(parts_.picture.mapToGlobal(addAt_.toPoint()));
}

void MainMenus::openContextMenu(const QPoint& at) {
    addAt_ = parts_.picture.mapFromGlobal(at);
    context_->popup(at);
}

void MainMenus::fillRecent(QMenu* menu) {
    menu->clear();
    for (const QString& file : parts_.files.recent())
        connect(menu->addAction(file), &QAction::triggered, this,
                [this, file] { parts_.files.open(toPath(file)); });
    if (menu->isEmpty()) menu->addAction(tr("None"))->setEnabled(false);
}

void MainMenus::fillCameras(QMenu* menu) {
    menu->clear();
    const Scene& scene = parts_.document.scene();
    const auto add = [&](CameraId id, const QString& name) {
        QAction* action = menu->addAction(name);
        action->setCheckable(true);
        action->setChecked(scene.activeCamera == id);
        connect(action, &QAction::triggered, this, [this, id] { parts_.edits.lookThrough(id); });
    };
    add({}, tr("Camera"));
    scene.cameras.forEach(
        [&](CameraId id, const Camera& camera) { add(id, toQString(camera.name)); });
}

void MainMenus::fillSavedViews(QMenu* menu) {
    menu->clear();
    const auto count = static_cast<int>(parts_.document.scene().views.size());
    for (int number = 1; number <= count; ++number) {
        QAction* go = menu->addAction(tr("Go to view %1").arg(number) +
                                      QStringLiteral("\tCtrl+%1").arg(number));
        connect(go, &QAction::triggered, this,
                [this, number] { parts_.views.goToSavedView(number); });
    }
    if (count > 0) menu->addSeparator();
    for (int number = 1; number <= std::min(count + 1, ViewCommands::kSavedViews); ++number) {
        QAction* store = menu->addAction(tr("Store as view %1").arg(number) +
                                         QStringLiteral("\tCtrl+Shift+%1").arg(number));
        connect(store, &QAction::triggered, this,
                [this, number] { parts_.views.storeView(number); });
    }
}

}  // namespace glint
