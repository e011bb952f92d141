#include "gui/panels/start_page.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/app/resources.h"
#include "gui/app/scene_thumbnails.h"
#include "gui/app/text.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/tile_list.h"

namespace glint {

namespace {

const QSize kThumbnail(168, 104);  ///< logical pixels

/// The picture in the middle of a tile of the full size, so that all tiles are alike.
QPixmap tile(const QImage& picture, double ratio) {
    QPixmap out(kThumbnail * ratio);
    out.fill(QColor(22, 22, 22));
    QPainter painter(&out);
    if (!picture.isNull()) {
        const QSize fitted = picture.size().scaled(out.size(), Qt::KeepAspectRatio);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(
            QRect(QPoint((out.width() - fitted.width()) / 2, (out.height() - fitted.height()) / 2),
                  fitted),
            picture);
    } else {
        const double side = 28 * ratio;
        drawIcon(painter, "image",
                 QRectF((out.width() - side) / 2, (out.height() - side) / 2, side, side),
                 QColor(96, 96, 96));
    }
    out.setDevicePixelRatio(ratio);
    return out;
}

// Names of the files that come with the program, for lupdate.
[[maybe_unused]] constexpr const char* kTitles[] = {
    QT_TRANSLATE_NOOP("SceneTitle", "Studio"),
    QT_TRANSLATE_NOOP("SceneTitle", "Outdoor"),
    QT_TRANSLATE_NOOP("SceneTitle", "Room"),
    QT_TRANSLATE_NOOP("SceneTitle", "Picture light"),
    QT_TRANSLATE_NOOP("SceneTitle", "Empty"),
    QT_TRANSLATE_NOOP("SceneTitle", "Columns"),
    QT_TRANSLATE_NOOP("SceneTitle", "Cornell"),
    QT_TRANSLATE_NOOP("SceneTitle", "Depth of field"),
    QT_TRANSLATE_NOOP("SceneTitle", "Glass study"),
    QT_TRANSLATE_NOOP("SceneTitle", "Many balls"),
    QT_TRANSLATE_NOOP("SceneTitle", "Materials"),
    QT_TRANSLATE_NOOP("SceneTitle", "Still life")};

}  // namespace

std::vector<std::filesystem::path> sceneFiles(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> out;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error))
        if (entry.path().extension() == ".json") out.push_back(entry.path());
    std::sort(out.begin(), out.end());
    return out;
}

QString sceneTitle(const std::filesystem::path& file) {
    QString name = pathText(file.stem().stem()).replace('_', ' ');
    if (!name.isEmpty()) name[0] = name[0].toUpper();
    return QCoreApplication::translate("SceneTitle", name.toUtf8().constData());
}

StartPage::StartPage(SceneThumbnails& thumbnails, const QStringList& recent, QWidget* parent)
    : QFrame(parent), thumbnails_(thumbnails) {
    setObjectName("startPage");
    setAutoFillBackground(true);
    setAccessibleName(tr("Start page"));
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(28, 20, 8, 20);
    outer->setSpacing(12);
    addHeader(outer);
    auto* scroll = new QScrollArea(this);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    auto* content = new QWidget(scroll);
    scroll->setWidget(content);
    outer->addWidget(scroll, 1);
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(0, 0, 12, 0);
    layout->setSpacing(8);
    addFiles(layout, tr("New from a template"), "start.templates", sceneFiles(templateFolder()),
             &StartPage::templateRequested);
    addFiles(layout, tr("Demos"), "start.demos", sceneFiles(demoFolder()),
             &StartPage::openRequested);
    std::vector<std::filesystem::path> files;
    for (const QString& file : recent) {
        std::error_code ignored;
        if (std::filesystem::exists(toPath(file), ignored) && files.size() < 6)
            files.push_back(toPath(file));
    }
    if (!files.empty())
        addFiles(layout, tr("Recent"), "start.recent", files, &StartPage::openRequested);
    layout->addStretch();
    addFooter(outer);
    connect(&thumbnails_, &SceneThumbnails::ready, this, &StartPage::showPicture);
}

void StartPage::addHeader(QVBoxLayout* layout) {
    auto* title = new QLabel(QStringLiteral("Glint"), this);
    QFont font = title->font();
    font.setPointSizeF(font.pointSizeF() * 1.8);
    font.setWeight(QFont::DemiBold);
    title->setFont(font);
    auto* close = new QPushButton(icon("close"), tr("Close"), this);
    close->setObjectName("start.close");
    close->setToolTip(tr("Go to the picture (Esc)"));
    connect(close, &QPushButton::clicked, this, &StartPage::closed);
    auto* row = new QHBoxLayout;
    row->addWidget(title);
    row->addStretch();
    row->addWidget(close);
    layout->addLayout(row);
}

void StartPage::addFiles(QVBoxLayout* layout, const QString& title, const QString& name,
                         const std::vector<std::filesystem::path>& files,
                         void (StartPage::*signal)(const std::filesystem::path&)) {
    auto* heading = new QLabel(title, this);
    heading->setEnabled(false);
    layout->addWidget(heading);
    auto* list = new TileList(kThumbnail, this);
    list->setObjectName(name);
    list->setAccessibleName(title);
    for (const auto& file : files) {
        auto* item =
            new QListWidgetItem(QIcon(tile({}, devicePixelRatioF())), sceneTitle(file), list);
        item->setData(Qt::UserRole, pathText(file));
        item->setToolTip(pathText(file));
    }
    connect(list, &QListWidget::itemActivated, this, [this, signal](QListWidgetItem* item) {
        emit(this->*signal)(toPath(item->data(Qt::UserRole).toString()));
    });
    connect(list, &QListWidget::itemClicked, list, &QListWidget::itemActivated);
    lists_.push_back(list);
    layout->addWidget(list);
    for (auto file = files.rbegin(); file != files.rend(); ++file)
        thumbnails_.request(*file, kThumbnail * devicePixelRatioF());
}

void StartPage::addFooter(QVBoxLayout* layout) {
    auto* open = new QPushButton(icon("open"), tr("Open a scene…"), this);
    open->setObjectName("start.open");
    connect(open, &QPushButton::clicked, this, &StartPage::browseRequested);
    auto* hint = new QLabel(tr("or drop a scene or an environment picture here"), this);
    hint->setEnabled(false);
    auto* row = new QHBoxLayout;
    row->addWidget(open);
    row->addWidget(hint);
    row->addStretch();
    layout->addLayout(row);
}

void StartPage::showPicture(const std::filesystem::path& file, const QImage& picture) {
    for (QListWidget* list : lists_)
        for (int row = 0; row < list->count(); ++row)
            if (toPath(list->item(row)->data(Qt::UserRole).toString()) == file)
                list->item(row)->setIcon(QIcon(tile(picture, devicePixelRatioF())));
}

void StartPage::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape)
        emit closed();
    else
        QFrame::keyPressEvent(event);
}

}  // namespace glint
