#include "gui/app/main_window.h"

#include <QAction>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QListView>
#include <QMimeData>
#include <QSettings>
#include <QStackedWidget>
#include <QStandardPaths>
#include <QStatusBar>
#include <QThread>
#include <QUndoView>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/app/actions.h"
#include "gui/app/autosave.h"
#include "gui/app/command_bindings.h"
#include "gui/app/command_search.h"
#include "gui/app/edit_controller.h"
#include "gui/app/error_report_dialog.h"
#include "gui/app/export_dialog.h"
#include "gui/app/export_queue.h"
#include "gui/app/file_controller.h"
#include "gui/app/file_watch.h"
#include "gui/app/main_menus.h"
#include "gui/app/material_previews.h"
#include "gui/app/message_log.h"
#include "gui/app/missing_assets.h"
#include "gui/app/narrow_layout.h"
#include "gui/app/picture_controls.h"
#include "gui/app/preferences_dialog.h"
#include "gui/app/preview_renderer.h"
#include "gui/app/renderer.h"
#include "gui/app/resources.h"
#include "gui/app/scene_thumbnails.h"
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
#include "gui/widgets/lazy_dock.h"
#include "gui/widgets/message_bar.h"
#include "gui/widgets/status_line.h"

namespace glint {

namespace {

/// How long a passing notice stands in the status line.
constexpr int kNoticeMs = 4000;

const QString kPictureSize = QStringLiteral("pictureSize");

QWidget* makeHistory(Document& document, QWidget* parent) {
    auto* history = new QUndoView(&document.undoStack(), parent);
    history->setEmptyLabel(MainWindow::tr("As opened"));
    history->setAccessibleName(MainWindow::tr("History"));
    history->setUniformItemSizes(true);  // Else every step measures all others.
    return history;
}

QWidget* makeLog(MessageLog& log, QWidget* parent) {
    auto* lines = new QListView(parent);
    lines->setModel(&log);
    lines->setWordWrap(true);
    lines->setAccessibleName(MainWindow::tr("Log"));
    return lines;
}

}  // namespace

MainWindow::MainWindow(Memory memory, std::optional<FileReading> scene, QWidget* parent)
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
    previews_->hold();
    // Queued: when the first picture has been handed to the screen.
    constexpr auto kOnceLater =
        static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection);
    connect(view_, &RenderView::pictureShown, this, &MainWindow::endStart, kOnceLater);
    materialPreviews_ = new MaterialPreviews(document_, *previews_, this);
    thumbnails_ = new SceneThumbnails(*previews_, memory_, this);
    new MaterialDrop(*view_);
    connect(&document_, &Document::replaced, this, &MainWindow::hideStartPage);
    bindSavedViews(*this, *viewCommands_);
    connectDisk();
    connect(&document_, &Document::titleChanged, this, &MainWindow::updateTitle);
    connect(&preferences_, &Preferences::changed, this, &MainWindow::applyPreferences);
    applyTheme(preferences_.values().theme);
    applyLanguage(preferences_.values().language);
    applyPreferences(preferences_.values());
    // The news of the language: too early to change anything, and later it would build the
    // interface a second time.
    QCoreApplication::sendPostedEvents(this, QEvent::LanguageChange);
    if (scene) beginWith(*std::move(scene));
    buildInterface();
    if (memory_ == Memory::None) return;
    QSettings settings;
    restoreGeometry(settings.value("geometry").toByteArray());
    restoreState(settings.value("layout").toByteArray());
    autosave_->begin(toPath(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)) /
                     "recovery");
    offerRecovery();
}

void MainWindow::beginWith(FileReading scene) {
    // Traced at the size of last time while the window is built, with one processor left for that.
    if (memory_ == Memory::Settings) renderer_->setSize(QSettings().value(kPictureSize).toSize());
    const int threads = preferences_.values().renderThreads;
    renderer_->setThreads(std::max(1, (threads > 0 ? threads : QThread::idealThreadCount()) - 1));
    files_->load(std::move(scene));
}

void MainWindow::endStart() {
    previews_->release();
    renderer_->setThreads(preferences_.values().renderThreads);
}

void MainWindow::buildInterface() {
    actions_ = new Actions(this, memory_);
    view_->setAccessibleName(RenderView::tr("Picture"));
    search_ = new CommandSearch(*actions_, this);
    status_ = new StatusLine(this);
    statusBar()->addWidget(status_, 1);
    buildDocks();
    narrow_ = new NarrowLayout(*this, actions_);
    menus_ = new MainMenus(
        {*actions_, document_, *files_, *edits_, *viewCommands_, *view_, *objects_}, *this);
    addToolBar(new ToolBar(document_, *view_, *actions_, this));
    connectFileActions();
    bindEditCommands(*actions_, *edits_, document_.undoStack(), selection_, *objects_);
    bindViewCommands(*actions_, *viewCommands_, *edits_, *view_);
    bindTools(*actions_, *view_);
    bindHelp(*actions_, *search_, *this);
    new MissingAssets(
        document_, *renderer_, [this]() -> EnvironmentPicker& { return environment(); }, *messages_,
        actions_);
    new PictureControls(*actions_, *renderer_, *view_, document_, selection_, actions_);
    connectState();
    updateTitle();
}

void MainWindow::removeInterface() {
    for (QDialog* dialog : findChildren<QDialog*>(Qt::FindDirectChildrenOnly))
        dialog->deleteLater();
    qDeleteAll(findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly));
    qDeleteAll(findChildren<QToolBar*>(Qt::FindDirectChildrenOnly));
    setMenuBar(nullptr);
    delete menus_;
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

LazyDock* MainWindow::addDock(const QString& name, const QString& title, Qt::DockWidgetArea area,
                              std::function<QWidget*(QWidget* parent)> make) {
    auto* dock = new LazyDock(title, std::move(make), this);
    dock->setObjectName(name);
    addDockWidget(area, dock);
    return dock;
}

void MainWindow::buildDocks() {
    LazyDock* objects =
        addDock("objects", tr("Objects"), Qt::LeftDockWidgetArea,
                [this](QWidget* parent) { return new ObjectList(document_, selection_, parent); });
    objects_ = static_cast<ObjectList*>(objects->content());
    LazyDock* materials =
        addDock("materials", tr("Materials"), Qt::LeftDockWidgetArea, [this](QWidget* parent) {
            return new MaterialPanel(document_, selection_, *materialPreviews_, parent);
        });
    materials_ = static_cast<MaterialPanel*>(materials->content());
    environment_ =
        addDock("environment", tr("Environment"), Qt::LeftDockWidgetArea, [this](QWidget* parent) {
            return new EnvironmentPicker(document_, environmentFolder(), parent);
        });
    LazyDock* properties = addDock(
        "properties", tr("Properties"), Qt::RightDockWidgetArea,
        [this](QWidget* parent) { return new PropertyPanel(document_, selection_, parent); });
    properties_ = static_cast<PropertyPanel*>(properties->content());
    properties_->setPreviews(*materialPreviews_);
    connect(materials_, &MaterialPanel::chosen, properties_, &PropertyPanel::showMaterial);
    connect(materials_, &MaterialPanel::refused, messages_,
            [this](const QString& reason) { messages_->show(MessageBar::Level::Warning, reason); });
    QDockWidget* render =
        addDock("render", tr("Render"), Qt::RightDockWidgetArea,
                [this](QWidget* parent) { return new RenderPanel(document_, parent); });
    QDockWidget* exports =
        addDock("exports", tr("Exports"), Qt::RightDockWidgetArea,
                [this](QWidget* parent) { return new ExportPanel(*exports_, parent); });
    QDockWidget* history =
        addDock("history", tr("History"), Qt::RightDockWidgetArea,
                [this](QWidget* parent) { return makeHistory(document_, parent); });
    QDockWidget* statistics = addDock(
        "statistics", tr("Statistics"), Qt::RightDockWidgetArea,
        [this](QWidget* parent) { return new StatisticsPanel(document_, *renderer_, parent); });
    QDockWidget* log = addDock("log", tr("Log"), Qt::RightDockWidgetArea,
                               [this](QWidget* parent) { return makeLog(*log_, parent); });
    tabifyDockWidget(materials, environment_);
    materials->raise();
    tabifyDockWidget(properties, render);
    tabifyDockWidget(render, history);
    tabifyDockWidget(history, exports);
    tabifyDockWidget(exports, statistics);
    tabifyDockWidget(statistics, log);
    // Seldom wanted, and six tabs would cut each other's names: the Window menu shows them, and an
    // export its own.
    exports->hide();
    statistics->hide();
    log->hide();
    inspector_ =
        addDock("inspector", tr("Pixel"), Qt::BottomDockWidgetArea, [this](QWidget* parent) {
            return new PixelInspector(document_, *renderer_, selection_, parent);
        });
    inspector_->hide();
    connect(view_, &RenderView::inspectRequested, inspector_, [this](const QPoint& pixel) {
        PixelInspector& content = inspector();
        inspector_->show();
        inspector_->raise();
        content.inspect(pixel);
    });
    properties->raise();
    const int unit = fontMetrics().averageCharWidth();
    // Wide enough for any form: a panel that grew with the selection would shrink the picture and
    // start it anew.
    resizeDocks({objects, properties}, {unit * 40, unit * 64}, Qt::Horizontal);
    resizeDocks({objects, materials}, {360, 380}, Qt::Vertical);
}

EnvironmentPicker& MainWindow::environment() {
    return static_cast<EnvironmentPicker&>(*environment_->content());
}

PixelInspector& MainWindow::inspector() {
    return static_cast<PixelInspector&>(*inspector_->content());
}

void MainWindow::connectFileActions() {
    actions_->on("file.new", files_, &FileController::newScene);
    actions_->on("file.startPage", this, &MainWindow::showStartPage);
    actions_->on("file.open", files_, &FileController::browse);
    actions_->on("file.save", files_, &FileController::save);
    actions_->on("file.saveAs", files_, &FileController::saveAs);
    actions_->on("file.export", this, &MainWindow::openExport);
    actions_->on("render.errorReport", this,
                 [this] { (new ErrorReportDialog(document_, this))->show(); });
    actions_->on("file.quit", this, &QWidget::close);
    actions_->on("render.pause", renderer_, [this](bool paused) { renderer_->setPaused(paused); });
    actions_->on("edit.preferences", this, &MainWindow::openPreferences);
    (*actions_)["window.light"]->setChecked(preferences_.values().theme == Theme::Light);
    actions_->on("window.light", this, [this](bool light) {
        PreferenceValues values = preferences_.values();
        values.theme = light ? Theme::Light : Theme::Dark;
        preferences_.set(values);
    });
    connect(&preferences_, &Preferences::changed, actions_, [this] {
        (*actions_)["window.light"]->setChecked(preferences_.values().theme == Theme::Light);
    });
}

void MainWindow::connectState() {
    const auto warn = [this](const QString& reason) {
        messages_->show(MessageBar::Level::Warning, reason);
    };
    connect(edits_, &EditController::refused, actions_, warn);
    connect(objects_, &ObjectList::refused, actions_, warn);
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
        statusBar()->showMessage(tr("Reloaded %1").arg(QFileInfo(changed.first()).fileName()),
                                 kNoticeMs);
    });
    connect(fileWatch_, &FileWatch::sceneFileChanged, this, [this] {
        messages_->show(MessageBar::Level::Info,
                        tr("%1 was changed by another program").arg(document_.title()), {},
                        {{tr("Reload"), [this] { files_->open(document_.file()); }}});
    });
    connect(autosave_.get(), &Autosave::failed, this, [this](const QString& reason) {
        messages_->show(MessageBar::Level::Warning,
                        tr("Unsaved work cannot be kept safe: %1").arg(reason));
    });
}

void MainWindow::offerRecovery() {
    const auto leftovers = autosave_->leftovers();
    if (leftovers.empty()) return;
    const Autosave::Leftover& found = leftovers.front();
    const QString name =
        found.original.empty() ? tr("an untitled scene") : pathText(found.original.filename());
    const auto recover = [this, found] {
        files_->whenSafe([this, found] {
            if (const Status status = autosave_->recover(found); !status)
                messages_->show(MessageBar::Level::Error,
                                tr("Not recovered: %1").arg(toQString(status.error())));
        });
    };
    const auto discard = [this, found] {
        Autosave::discard(found);
        offerRecovery();
    };
    recoveryBar_->show(MessageBar::Level::Warning,
                       tr("Glint ended with unsaved changes to %1, kept at %2.")
                           .arg(name, QLocale().toString(found.time, QLocale::ShortFormat)),
                       pathText(found.copy), {{tr("Recover"), recover}, {tr("Discard"), discard}});
}

void MainWindow::updateTitle() {
    setWindowTitle(
        QStringLiteral("%1%2 — Glint")
            .arg(document_.title(), document_.isModified() ? QStringLiteral(" *") : QString()));
}

void MainWindow::updateSelectionText() {
    const auto& items = selection_.items();
    if (items.size() > 1)
        return status_->showSelection(tr("%n selected", nullptr, static_cast<int>(items.size())));
    if (items.empty()) return status_->showSelection({});
    const std::string name = nameOf(document_.scene(), items.front());
    status_->showSelection(name.empty() ? tr("Camera") : toQString(name));
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

void MainWindow::openPreferences() {
    (new PreferencesDialog(preferences_, *actions_, this))->show();
}

void MainWindow::showStartPage() {
    hideStartPage();
    previews_->release();
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
    autosave_->setDelay(now.autosaveSeconds > 0
                            ? std::optional(std::chrono::seconds(now.autosaveSeconds))
                            : std::nullopt);
    renderer_->setThreads(now.renderThreads);
    view_->context().navigation = {now.invertWheel, now.orbitSelection};
}

void MainWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() != QEvent::LanguageChange || !actions_) return;
    const QByteArray layout = narrow_->wideState();
    const bool preferencesOpen = findChild<PreferencesDialog*>() != nullptr;
    removeInterface();
    messages_->dismiss();
    buildInterface();
    restoreState(layout);
    if (preferencesOpen) openPreferences();
    if (pages_->count() > 1) showStartPage();
}

void MainWindow::openDropped(const std::filesystem::path& file) {
    if (isPicture(file))
        environment().choose(file);
    else
        files_->open(file);
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
        settings.setValue("layout", narrow_->wideState());
        settings.setValue(kPictureSize, renderer_->size());
    }
    event->accept();
}

}  // namespace glint
