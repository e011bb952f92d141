#include "gui/app/main_window.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QClipboard>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QListView>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>
#include <QShortcut>
#include <QStackedWidget>
#include <QStandardPaths>
#include <QStatusBar>
#include <QUndoView>
#include <QVBoxLayout>

#include "gui/app/actions.h"
#include "gui/app/autosave.h"
#include "gui/app/command_search.h"
#include "gui/app/edit_controller.h"
#include "gui/app/error_report_dialog.h"
#include "gui/app/export_dialog.h"
#include "gui/app/export_queue.h"
#include "gui/app/file_controller.h"
#include "gui/app/file_watch.h"
#include "gui/app/material_previews.h"
#include "gui/app/message_log.h"
#include "gui/app/picture_controls.h"
#include "gui/app/preferences_dialog.h"
#include "gui/app/preview_renderer.h"
#include "gui/app/renderer.h"
#include "gui/app/resources.h"
#include "gui/app/scene_thumbnails.h"
#include "gui/app/shortcut_sheet.h"
#include "gui/app/text.h"
#include "gui/app/theme.h"
#include "gui/app/tool_bar.h"
#include "gui/panels/environment_picker.h"
#include "gui/panels/export_panel.h"
#include "gui/panels/material_panel.h"
#include "gui/panels/object_list.h"
#include "gui/panels/pixel_inspector.h"
#include "gui/panels/property_panel.h"
#include "gui/panels/render_panel.h"
#include "gui/panels/start_page.h"
#include "gui/panels/statistics_panel.h"
#include "gui/panels/thumbnails.h"
#include "gui/viewport/material_drop.h"
#include "gui/viewport/render_view.h"
#include "gui/viewport/view_commands.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/message_bar.h"
#include "gui/widgets/status_line.h"

namespace glint {

namespace {

/// How long a passing notice stands in the status line.
constexpr int kNoticeMs = 4000;

}  // namespace

MainWindow::MainWindow(Memory memory, QWidget* parent)
    : QMainWindow(parent), memory_(memory), preferences_(memory), selection_(document_) {
    setAcceptDrops(true);
    setDockNestingEnabled(true);
    document_.replace(starterScene(), {});
    autosave_ = std::make_unique<Autosave>(document_);
    renderer_ = new Renderer(document_, this);
    buildCenter();
    viewCommands_ = new ViewCommands(*view_, this);
    edits_ = new EditController(document_, selection_, *view_, this);
    files_ = new FileController(document_, *messages_, memory_, this);
    exports_ = new ExportQueue(*messages_, this);
    previews_ = new PreviewRenderer(this);
    materialPreviews_ = new MaterialPreviews(document_, *previews_, this);
    thumbnails_ = new SceneThumbnails(*previews_, memory_, this);
    new MaterialDrop(*view_);
    connect(&document_, &Document::replaced, this, &MainWindow::hideStartPage);
    connectSavedViews();
    connectDisk();
    connect(&document_, &Document::titleChanged, this, &MainWindow::updateTitle);
    connect(&preferences_, &Preferences::changed, this, &MainWindow::applyPreferences);
    applyTheme(preferences_.values().theme);
    applyLanguage(preferences_.values().language);
    applyPreferences(preferences_.values());
    buildInterface();
    if (memory_ == Memory::None) return;
    QSettings settings;
    restoreGeometry(settings.value("geometry").toByteArray());
    restoreState(settings.value("layout").toByteArray());
    autosave_->begin(toPath(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)) / "recovery");
    offerRecovery();
}

void MainWindow::buildInterface() {
    actions_ = new Actions(this, memory_);
    view_->setAccessibleName(RenderView::tr("Picture"));
    search_ = new CommandSearch(*actions_, this);
    status_ = new StatusLine(this);
    statusBar()->addWidget(status_, 1);
    buildDocks();
    buildMenus();
    buildToolBar();
    connectFileActions();
    connectEditActions();
    connectViewActions();
    connectTools();
    connectState();
    updateTitle();
}

void MainWindow::removeInterface() {
    for (QDialog* dialog : findChildren<QDialog*>(Qt::FindDirectChildrenOnly)) dialog->deleteLater();
    qDeleteAll(findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly));
    qDeleteAll(findChildren<QToolBar*>(Qt::FindDirectChildrenOnly));
    setMenuBar(nullptr);
    delete contextMenu_;
    delete search_;
    delete status_;
    delete actions_;
}

MainWindow::~MainWindow() {
    // Hiding ends what is being typed, while the document is still there to take it.
    hide();
    // The renderer's threads must not outlive the document they report on.
    delete renderer_;
}

void MainWindow::buildCenter() {
    auto* center = new QWidget(this);
    messages_ = new MessageBar(center);
    recoveryBar_ = new MessageBar(center);
    view_ = new RenderView(document_, selection_, *renderer_, center);
    auto* layout = new QVBoxLayout(center);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(recoveryBar_);
    layout->addWidget(messages_);
    pages_ = new QStackedWidget(center);
    pages_->addWidget(view_);
    layout->addWidget(pages_, 1);
    log_ = new MessageLog(*messages_, this);
    setCentralWidget(center);
    statusBar()->setSizeGripEnabled(false);
}

QDockWidget* MainWindow::addDock(const QString& name, const QString& title, QWidget* content, Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    dock->setWidget(content);
    addDockWidget(area, dock);
    return dock;
}

void MainWindow::buildDocks() {
    objects_ = new ObjectList(document_, selection_, this);
    environment_ = new EnvironmentPicker(document_, environmentFolder(), this);
    properties_ = new PropertyPanel(document_, selection_, this);
    properties_->setPreviews(*materialPreviews_);
    materials_ = new MaterialPanel(document_, selection_, *materialPreviews_, this);
    connect(materials_, &MaterialPanel::chosen, properties_, &PropertyPanel::showMaterial);
    connect(materials_, &MaterialPanel::refused, messages_, [this](const QString& reason) { messages_->show(MessageBar::Level::Warning, reason); });
    auto* history = new QUndoView(&document_.undoStack(), this);
    history->setEmptyLabel(tr("As opened"));
    QDockWidget* objects = addDock("objects", tr("Objects"), objects_, Qt::LeftDockWidgetArea);
    QDockWidget* materials = addDock("materials", tr("Materials"), materials_, Qt::LeftDockWidgetArea);
    QDockWidget* environment = addDock("environment", tr("Environment"), environment_, Qt::LeftDockWidgetArea);
    QDockWidget* properties = addDock("properties", tr("Properties"), properties_, Qt::RightDockWidgetArea);
    QDockWidget* render = addDock("render", tr("Render"), new RenderPanel(document_, this), Qt::RightDockWidgetArea);
    QDockWidget* exports = addDock("exports", tr("Exports"), new ExportPanel(*exports_, this), Qt::RightDockWidgetArea);
    QDockWidget* steps = addDock("history", tr("History"), history, Qt::RightDockWidgetArea);
    auto* lines = new QListView(this);
    lines->setModel(log_);
    lines->setWordWrap(true);
    lines->setAccessibleName(tr("Log"));
    QDockWidget* statistics = addDock("statistics", tr("Statistics"), new StatisticsPanel(document_, *renderer_, this), Qt::RightDockWidgetArea);
    QDockWidget* log = addDock("log", tr("Log"), lines, Qt::RightDockWidgetArea);
    tabifyDockWidget(materials, environment);
    materials->raise();
    tabifyDockWidget(properties, render);
    tabifyDockWidget(render, steps);
    tabifyDockWidget(steps, exports);
    tabifyDockWidget(exports, statistics);
    tabifyDockWidget(statistics, log);
    // Seldom wanted, and six tabs would cut each other's names: the Window menu shows them, and an export its own.
    exports->hide();
    statistics->hide();
    log->hide();
    inspector_ = new PixelInspector(document_, *renderer_, selection_, this);
    QDockWidget* inspector = addDock("inspector", tr("Pixel"), inspector_, Qt::BottomDockWidgetArea);
    inspector->hide();
    connect(view_, &RenderView::inspectRequested, inspector, [this, inspector](const QPoint& pixel) {
        inspector->show();
        inspector->raise();
        inspector_->inspect(pixel);
    });
    properties->raise();
    const int unit = fontMetrics().averageCharWidth();
    // Wide enough for any form: a panel that grew with the selection would shrink the picture and start it anew.
    resizeDocks({objects, properties}, {unit * 40, unit * 58}, Qt::Horizontal);
    resizeDocks({objects, materials}, {360, 380}, Qt::Vertical);
}

void MainWindow::buildMenus() {
    const auto menu = [this](const QString& title, std::initializer_list<const char*> ids) {
        QMenu* added = menuBar()->addMenu(title);
        added->setToolTipsVisible(true);
        actions_->fill(added, ids);
        return added;
    };
    QMenu* file = menu(tr("&File"), {"file.new"});
    QMenu* templates = file->addMenu(tr("New from &template"));
    for (const auto& path : sceneFiles(templateFolder()))
        connect(templates->addAction(sceneTitle(path)), &QAction::triggered, this, [this, path] { files_->newFrom(path); });
    actions_->fill(file, {"file.startPage", "-", "file.open"});
    QMenu* recent = file->addMenu(tr("Open &recent"));
    connect(recent, &QMenu::aboutToShow, this, [this, recent] { fillRecentMenu(recent); });
    actions_->fill(file, {"-", "file.save", "file.saveAs", "-", "file.export", "-", "file.quit"});
    menu(tr("&Edit"), {"edit.undo", "edit.redo", "-", "edit.cut", "edit.copy", "edit.paste", "edit.duplicate", "edit.delete", "-",
                       "edit.selectAll", "edit.selectNone", "edit.rename", "-", "edit.hide", "edit.hideRest", "edit.showAll", "-", "edit.group", "edit.ungroup", "-", "edit.preferences"});
    addMenu_ = menuBar()->addMenu(tr("&Add"));
    edits_->fillAddMenu(addMenu_, [this] { return addAt_.isNull() ? QRectF(view_->rect()).center() : addAt_; });
    objects_->setAddMenu(addMenu_);
    QMenu* viewMenu = menu(tr("&View"), {"tool.select", "tool.move", "tool.rotate", "tool.scale", "tool.snap", "-", "view.frameSelected", "view.frameAll", "-",
                       "view.front", "view.behind", "view.right", "view.left", "view.top", "view.bottom", "-", "view.projection",
                       "view.camera", "-", "view.previous", "view.next", "-", "view.overlay", "view.grid", "-", "view.filter", "view.darker", "view.brighter"});
    QMenu* cameras = viewMenu->addMenu((*actions_)["view.camera"]->icon(), tr("Ca&meras"));
    cameras->setObjectName("cameras");
    connect(cameras, &QMenu::aboutToShow, this, [this, cameras] { fillCameraMenu(cameras); });
    QMenu* saved = viewMenu->addMenu(tr("Sa&ved views"));
    connect(saved, &QMenu::aboutToShow, this, [this, saved] { fillSavedViewMenu(saved); });
    QMenu* render = menu(tr("&Render"), {"render.pause", "-", "view.region", "view.regionClear", "view.isolate", "-", "render.inspect"});
    QMenu* channels = render->addMenu(tr("&Channel"));
    channels->setToolTipsVisible(true);
    for (const char* id : kChannelActions) channels->addAction((*actions_)[id]);
    actions_->fill(render, {"-", "render.copy", "-", "render.errorReport", "-", "file.export"});
    QMenu* window = menuBar()->addMenu(tr("&Window"));
    for (QDockWidget* dock : findChildren<QDockWidget*>()) window->addAction(dock->toggleViewAction());
    actions_->fill(window, {"-", "window.light"});
    menu(tr("&Help"), {"help.shortcuts", "help.search", "-", "help.about"});

    contextMenu_ = new QMenu(this);
    contextMenu_->addMenu(addMenu_);
    actions_->fill(contextMenu_, {"-", "edit.cut", "edit.copy", "edit.paste", "edit.duplicate", "edit.delete", "edit.rename", "-", "edit.hide", "edit.hideRest", "edit.showAll", "edit.group", "edit.ungroup",
                                  "-", "view.frameSelected", "view.frameAll", "-"});
    connect(contextMenu_->addAction(tr("&Inspect pixel")), &QAction::triggered, this, [this] { view_->inspect(addAt_); });
}

void MainWindow::buildToolBar() { addToolBar(new ToolBar(document_, *view_, *actions_, this)); }

void MainWindow::fillRecentMenu(QMenu* menu) {
    menu->clear();
    for (const QString& file : files_->recent())
        connect(menu->addAction(file), &QAction::triggered, this, [this, file] { files_->open(toPath(file)); });
    if (menu->isEmpty()) menu->addAction(tr("None"))->setEnabled(false);
}

void MainWindow::fillCameraMenu(QMenu* menu) {
    menu->clear();
    const Scene& scene = document_.scene();
    const auto add = [&](CameraId id, const QString& name) {
        QAction* action = menu->addAction(name);
        action->setCheckable(true);
        action->setChecked(scene.activeCamera == id);
        connect(action, &QAction::triggered, this, [this, id] { edits_->lookThrough(id); });
    };
    add({}, tr("Camera"));
    scene.cameras.forEach([&](CameraId id, const Camera& camera) { add(id, toQString(camera.name)); });
}

void MainWindow::fillSavedViewMenu(QMenu* menu) {
    menu->clear();
    const auto count = static_cast<int>(document_.scene().views.size());
    constexpr int kMostViews = 9;
    for (int number = 1; number <= count; ++number) {
        QAction* go = menu->addAction(tr("Go to view %1").arg(number) + QStringLiteral("\tCtrl+%1").arg(number));
        connect(go, &QAction::triggered, this, [this, number] { viewCommands_->goToSavedView(number); });
    }
    if (count > 0) menu->addSeparator();
    for (int number = 1; number <= std::min(count + 1, kMostViews); ++number) {
        QAction* store = menu->addAction(tr("Store as view %1").arg(number) + QStringLiteral("\tCtrl+Shift+%1").arg(number));
        connect(store, &QAction::triggered, this, [this, number] { viewCommands_->storeView(number); });
    }
}

void MainWindow::connectFileActions() {
    actions_->on("file.new", files_, &FileController::newScene);
    actions_->on("file.startPage", this, &MainWindow::showStartPage);
    actions_->on("file.open", files_, &FileController::browse);
    actions_->on("file.save", files_, &FileController::save);
    actions_->on("file.saveAs", files_, &FileController::saveAs);
    actions_->on("file.export", this, &MainWindow::openExport);
    actions_->on("render.errorReport", this, [this] { (new ErrorReportDialog(document_, this))->show(); });
    actions_->on("file.quit", this, &QWidget::close);
    actions_->on("render.pause", renderer_, [this](bool paused) { renderer_->setPaused(paused); });
    actions_->on("render.copy", this, [this] {
        const SessionFrame* frame = renderer_->frame();
        if (!frame || frame->width == 0) return;
        const QImage image(reinterpret_cast<const uchar*>(frame->pixels.data()), frame->width, frame->height, frame->width * 4, QImage::Format_RGB32);
        QApplication::clipboard()->setImage(image.copy());
    });
    actions_->on("help.shortcuts", this, [this] { (new ShortcutSheet(*actions_, this))->show(); });
    actions_->on("help.search", search_, &CommandSearch::open);
    actions_->on("help.about", this, [this] {
        auto* box = new QMessageBox(QMessageBox::Information, tr("About Glint"),
                                    tr("Glint %1\nA scene editor whose viewport is a ray tracer.\nMIT licence.").arg(GLINT_VERSION), QMessageBox::Ok, this);
        box->setAttribute(Qt::WA_DeleteOnClose);
        box->setModal(false);
        box->show();
    });
    actions_->on("edit.preferences", this, &MainWindow::openPreferences);
    (*actions_)["window.light"]->setChecked(preferences_.values().theme == Theme::Light);
    actions_->on("window.light", this, [this](bool light) {
        PreferenceValues values = preferences_.values();
        values.theme = light ? Theme::Light : Theme::Dark;
        preferences_.set(values);
    });
    connect(&preferences_, &Preferences::changed, actions_,
            [this] { (*actions_)["window.light"]->setChecked(preferences_.values().theme == Theme::Light); });
}

void MainWindow::connectEditActions() {
    QUndoStack* stack = &document_.undoStack();
    QAction* undo = (*actions_)["edit.undo"];
    QAction* redo = (*actions_)["edit.redo"];
    actions_->on("edit.undo", stack, &QUndoStack::undo);
    actions_->on("edit.redo", stack, &QUndoStack::redo);
    const auto update = [=] {
        undo->setEnabled(stack->canUndo());
        redo->setEnabled(stack->canRedo());
        undo->setText(stack->canUndo() ? tr("&Undo %1").arg(stack->undoText()) : tr("&Undo"));
        redo->setText(stack->canRedo() ? tr("&Redo %1").arg(stack->redoText()) : tr("&Redo"));
    };
    connect(stack, &QUndoStack::indexChanged, actions_, update);
    connect(stack, &QUndoStack::undoTextChanged, actions_, update);
    update();
    actions_->on("edit.cut", edits_, &EditController::cut);
    // With nothing selected it is the picture that is looked at, and copied.
    actions_->on("edit.copy", this, [this] { selection_.isEmpty() ? (*actions_)["render.copy"]->trigger() : edits_->copy(); });
    actions_->on("edit.paste", edits_, &EditController::paste);
    actions_->on("edit.duplicate", edits_, &EditController::duplicate);
    actions_->on("edit.delete", edits_, &EditController::remove);
    actions_->on("edit.selectAll", edits_, &EditController::selectAll);
    actions_->on("edit.selectNone", this, [this] { selection_.clear(); });
    actions_->on("edit.rename", objects_, &ObjectList::renameActive);
    actions_->on("edit.hide", edits_, &EditController::hideSelected);
    actions_->on("edit.hideRest", edits_, &EditController::hideRest);
    actions_->on("edit.showAll", edits_, &EditController::showAll);
    actions_->on("edit.group", edits_, &EditController::group);
    actions_->on("edit.ungroup", edits_, &EditController::ungroup);
    actions_->on("add.menu", this, &MainWindow::openAddMenu);
    const auto warn = [this](const QString& reason) { messages_->show(MessageBar::Level::Warning, reason); };
    connect(edits_, &EditController::refused, actions_, warn);
    connect(objects_, &ObjectList::refused, actions_, warn);
    const auto openContextMenu = [this](const QPoint& at) {
        addAt_ = view_->mapFromGlobal(at);
        contextMenu_->popup(at);
    };
    connect(view_, &RenderView::menuRequested, actions_, openContextMenu);
    connect(objects_, &ObjectList::menuRequested, actions_, openContextMenu);
}

void MainWindow::connectViewActions() {
    actions_->on("view.frameSelected", viewCommands_, &ViewCommands::frameSelected);
    actions_->on("view.frameAll", viewCommands_, &ViewCommands::frameAll);
    const std::pair<const char*, DVec3> directions[] = {{"view.front", {0, 0, -1}}, {"view.behind", {0, 0, 1}}, {"view.right", {-1, 0, 0}},
                                                        {"view.left", {1, 0, 0}},   {"view.top", {0, -1, 0}},   {"view.bottom", {0, 1, 0}}};
    for (const auto& [id, direction] : directions)
        actions_->on(id, viewCommands_, [this, direction = direction] { viewCommands_->lookAlong(direction); });
    actions_->on("view.projection", viewCommands_, &ViewCommands::toggleProjection);
    actions_->on("view.previous", viewCommands_, &ViewCommands::back);
    actions_->on("view.next", viewCommands_, &ViewCommands::forward);
    actions_->on("view.camera", edits_, &EditController::lookThroughSelectedCamera);
    actions_->on("view.overlay", view_, &RenderView::setOverlayShown);
    actions_->on("view.grid", view_, &RenderView::setGridShown);
    (*actions_)["view.overlay"]->setChecked(view_->isOverlayShown());
    (*actions_)["view.grid"]->setChecked(view_->isGridShown());
    actions_->on("render.inspect", view_, [this] { view_->inspect(view_->pointerOrCenter()); });
    new PictureControls(*actions_, *renderer_, *view_, document_, selection_, actions_);
    constexpr double kHalfStop = 0.5;
    actions_->on("view.darker", edits_, [this] { edits_->changeExposure(-kHalfStop); });
    actions_->on("view.brighter", edits_, [this] { edits_->changeExposure(kHalfStop); });
}

void MainWindow::connectTools() {
    auto* group = new QActionGroup(actions_);
    const std::pair<const char*, Tool> tools[] = {{"tool.select", Tool::Select}, {"tool.move", Tool::Move}, {"tool.rotate", Tool::Rotate}, {"tool.scale", Tool::Scale}};
    for (const auto& [id, tool] : tools) {
        QAction* action = (*actions_)[id];
        group->addAction(action);
        action->setChecked(view_->tools().tool == tool);
        connect(action, &QAction::triggered, this, [this, tool = tool] {
            ToolOptions options = view_->tools();
            options.tool = tool;
            view_->setTools(options);
        });
    }
    (*actions_)["tool.snap"]->setChecked(view_->tools().snap);
    actions_->on("tool.snap", this, [this](bool on) {
        ToolOptions options = view_->tools();
        options.snap = on;
        view_->setTools(options);
    });
}

void MainWindow::connectSavedViews() {
    for (int number = 1; number <= 9; ++number) {
        const auto key = static_cast<Qt::Key>(Qt::Key_0 + number);
        auto* go = new QShortcut(QKeySequence(Qt::CTRL | key), this);
        auto* store = new QShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | key), this);
        connect(go, &QShortcut::activated, viewCommands_, [this, number] { viewCommands_->goToSavedView(number); });
        connect(store, &QShortcut::activated, viewCommands_, [this, number] { viewCommands_->storeView(number); });
    }
}

void MainWindow::connectState() {
    const auto updateSelection = [this] { updateSelectionText(); };
    connect(&selection_, &Selection::changed, actions_, updateSelection);
    connect(&document_, &Document::changed, actions_, updateSelection);
    const auto showFrame = [this] {
        if (renderer_->frame()) status_->showFrame(*renderer_->frame());
    };
    connect(renderer_, &Renderer::frameReady, actions_, showFrame);
    connect(view_, &RenderView::pixelHovered, status_, &StatusLine::showPixel);
    const auto showPaused = [this](bool paused) {
        (*actions_)["render.pause"]->setChecked(paused);
        (*actions_)["render.pause"]->setIcon(icon(paused ? "play" : "pause"));
    };
    connect(renderer_, &Renderer::pausedChanged, actions_, showPaused);
    updateSelection();
    showFrame();
    showPaused(renderer_->isPaused());
}

void MainWindow::connectDisk() {
    fileWatch_ = new FileWatch(document_, this);
    connect(files_, &FileController::saved, fileWatch_, &FileWatch::noteSceneFile);
    connect(fileWatch_, &FileWatch::assetsChanged, this, [this](const QStringList& changed) {
        renderer_->reload();
        statusBar()->showMessage(tr("Reloaded %1").arg(QFileInfo(changed.first()).fileName()), kNoticeMs);
    });
    connect(fileWatch_, &FileWatch::sceneFileChanged, this, [this] {
        messages_->show(MessageBar::Level::Info, tr("%1 was changed by another program").arg(document_.title()), {},
                        {{tr("Reload"), [this] { files_->open(document_.file()); }}});
    });
    connect(autosave_.get(), &Autosave::failed, this, [this](const QString& reason) {
        messages_->show(MessageBar::Level::Warning, tr("Unsaved work cannot be kept safe: %1").arg(reason));
    });
}

void MainWindow::offerRecovery() {
    const auto leftovers = autosave_->leftovers();
    if (leftovers.empty()) return;
    const Autosave::Leftover found = leftovers.front();
    const QString name = found.original.empty() ? tr("an untitled scene") : pathText(found.original.filename());
    const auto recover = [this, found] {
        files_->whenSafe([this, found] {
            if (const Status status = autosave_->recover(found); !status)
                messages_->show(MessageBar::Level::Error, tr("Not recovered: %1").arg(toQString(status.error())));
        });
    };
    const auto discard = [this, found] {
        Autosave::discard(found);
        offerRecovery();
    };
    recoveryBar_->show(MessageBar::Level::Warning,
                       tr("Glint ended with unsaved changes to %1, kept at %2.").arg(name, QLocale().toString(found.time, QLocale::ShortFormat)),
                       pathText(found.copy), {{tr("Recover"), recover}, {tr("Discard"), discard}});
}

void MainWindow::updateTitle() {
    setWindowTitle(QStringLiteral("%1%2 — Glint").arg(document_.title(), document_.isModified() ? QStringLiteral(" *") : QString()));
}

void MainWindow::updateSelectionText() {
    const auto& items = selection_.items();
    if (items.size() > 1) return status_->showSelection(tr("%n selected", nullptr, static_cast<int>(items.size())));
    if (items.empty()) return status_->showSelection({});
    const std::string name = nameOf(document_.scene(), items.front());
    status_->showSelection(name.empty() ? tr("Camera") : toQString(name));
}

void MainWindow::openAddMenu() {
    addAt_ = view_->pointerOrCenter();
    addMenu_->popup(view_->mapToGlobal(addAt_.toPoint()));
}

void MainWindow::openExport() {
    auto* dialog = new ExportDialog(document_, this);
    connect(dialog, &ExportDialog::requested, this, [this](const ExportRequest& request) {
        exports_->add(request);
        auto* dock = findChild<QDockWidget*>("exports");
        dock->show();
        dock->raise();
    });
    dialog->show();
}

void MainWindow::openPreferences() { (new PreferencesDialog(preferences_, *actions_, this))->show(); }

void MainWindow::showStartPage() {
    hideStartPage();
    auto* page = new StartPage(*thumbnails_, files_->recent(), pages_);
    connect(page, &StartPage::openRequested, files_, &FileController::open);
    connect(page, &StartPage::templateRequested, files_, &FileController::newFrom);
    connect(page, &StartPage::browseRequested, files_, &FileController::browse);
    connect(page, &StartPage::closed, this, &MainWindow::hideStartPage);
    pages_->setCurrentIndex(pages_->addWidget(page));
    page->setFocus();
}

void MainWindow::hideStartPage() {
    QWidget* page = pages_->widget(1);
    if (!page) return;
    pages_->removeWidget(page);
    page->deleteLater();
    view_->setFocus();
}

void MainWindow::applyPreferences(const PreferenceValues& before) {
    const PreferenceValues& now = preferences_.values();
    if (now.theme != before.theme) applyTheme(now.theme);
    if (now.language != before.language) applyLanguage(now.language);
    autosave_->setDelay(now.autosaveSeconds > 0 ? std::optional(std::chrono::seconds(now.autosaveSeconds)) : std::nullopt);
    renderer_->setThreads(now.renderThreads);
    view_->context().navigation = {now.invertWheel, now.orbitSelection};
}

void MainWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() != QEvent::LanguageChange || !actions_) return;
    const QByteArray layout = saveState();
    const bool preferencesOpen = findChild<PreferencesDialog*>() != nullptr;
    removeInterface();
    messages_->dismiss();
    buildInterface();
    restoreState(layout);
    if (preferencesOpen) openPreferences();
    if (pages_->count() > 1) showStartPage();
}

void MainWindow::openDropped(const std::filesystem::path& file) {
    if (isPicture(file)) environment_->choose(file);
    else files_->open(file);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    for (const QUrl& url : event->mimeData()->urls())
        if (url.isLocalFile()) return openDropped(toPath(url.toLocalFile()));
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!closing_ && document_.isModified()) {
        event->ignore();
        files_->whenSafe([this] {
            closing_ = true;
            close();
        });
        return;
    }
    exports_->cancelAll();
    autosave_->end();
    if (memory_ == Memory::Settings) {
        QSettings settings;
        settings.setValue("geometry", saveGeometry());
        settings.setValue("layout", saveState());
    }
    event->accept();
}

}  // namespace glint
