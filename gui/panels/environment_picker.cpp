#include "gui/panels/environment_picker.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

#include "gui/app/asset_paths.h"
#include "gui/app/document.h"
#include "gui/app/text.h"
#include "gui/panels/environment_dials.h"
#include "gui/panels/form_builder.h"
#include "gui/panels/form_panel.h"
#include "gui/panels/thumbnails.h"
#include "gui/widgets/icons.h"

namespace glint {

namespace {

constexpr int kPathRole = Qt::UserRole, kRequestedRole = Qt::UserRole + 1;
constexpr int kNoneRow = 0, kSkyRow = 1, kFirstPicture = 2;
/// Stands for the computed sky; no file has an empty folder name.
const QString kSkyPath = QStringLiteral("//sky");
const QSize kThumbnail(88, 44);

/// A plain picture with an icon, while there is no thumbnail.
QPixmap placeholder(const QString& name, const QColor& background) {
    QPixmap pixmap(kThumbnail);
    pixmap.fill(background);
    QPainter painter(&pixmap);
    drawIcon(painter, name, QRectF(kThumbnail.width() / 2 - 8, kThumbnail.height() / 2 - 8, 16, 16),
             QColor(150, 150, 150));
    return pixmap;
}

void buildForm(FormBuilder& form) {
    form.addStruct(EnvironmentPicker::tr("Environment"), "environment",
                   partOf(&Scene::environment));
}

}  // namespace

EnvironmentPicker::EnvironmentPicker(Document& document, const std::filesystem::path& folder,
                                     QWidget* parent)
    : QWidget(parent), document_(document) {
    buildThumbnails();
    for (const auto& file : environmentFiles(folder)) addThumbnail(file);

    auto* browseButton = new QPushButton(icon("open"), tr("Open picture…"), this);
    browseButton->setToolTip(tr("Any latitude-longitude picture: EXR, HDR, PNG, JPEG, TIFF"));
    connect(browseButton, &QPushButton::clicked, this, &EnvironmentPicker::browse);
    auto* form = new FormPanel(
        document, buildForm,
        [](const Scene& s) { return QString::number(s.environment.sky.has_value()); }, this);
    form->setAccessibleName(tr("Environment settings"));

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(4);
    layout->addWidget(thumbnails_);
    layout->addWidget(browseButton);
    layout->addWidget(new EnvironmentDials(document, this));
    layout->addWidget(form, 1);
    connect(&document, &Document::changed, this, &EnvironmentPicker::showCurrent);
    showCurrent();
}

void EnvironmentPicker::buildThumbnails() {
    thumbnails_ = new QListWidget(this);
    thumbnails_->setViewMode(QListView::IconMode);
    thumbnails_->setIconSize(kThumbnail);
    thumbnails_->setResizeMode(QListView::Adjust);
    thumbnails_->setMovement(QListView::Static);
    thumbnails_->setSpacing(4);
    thumbnails_->setWordWrap(true);
    thumbnails_->setTextElideMode(Qt::ElideRight);
    thumbnails_->setAccessibleName(tr("Environment pictures"));
    thumbnails_->setMinimumHeight(kThumbnail.height() + fontMetrics().height() * 2);
    thumbnails_->setMaximumHeight((kThumbnail.height() + fontMetrics().height() * 2) * 2);
    auto* none = new QListWidgetItem(QIcon(placeholder("close", QColor(20, 20, 20))), tr("None"),
                                     thumbnails_);
    none->setData(kPathRole, QString());
    none->setToolTip(tr("No picture: the colour below alone"));
    auto* sky = new QListWidgetItem(QIcon(placeholder("light-sun", QColor(70, 110, 165))),
                                    tr("Computed sky"), thumbnails_);
    sky->setData(kPathRole, kSkyPath);
    sky->setToolTip(tr("Sky and sun, computed from the place of the sun"));
    connect(thumbnails_, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) {
        const QString path = item->data(kPathRole).toString();
        if (path.isEmpty())
            chooseNone();
        else if (path == kSkyPath)
            chooseSky();
        else
            choose(toPath(path));
    });
    connect(thumbnails_, &QListWidget::itemClicked, thumbnails_, &QListWidget::itemActivated);
}

void EnvironmentPicker::addThumbnail(const std::filesystem::path& image) {
    auto* item = new QListWidgetItem(QIcon(placeholder("image", QColor(50, 50, 50))),
                                     pathText(image.stem()), thumbnails_);
    item->setData(kPathRole, pathText(image));
    item->setToolTip(pathText(image));
    update();
}

void EnvironmentPicker::requestThumbnails() {
    for (int i = kFirstPicture; i < thumbnails_->count(); ++i) {
        QListWidgetItem* item = thumbnails_->item(i);
        if (item->data(kRequestedRole).toBool()) continue;
        item->setData(kRequestedRole, true);
        const auto image = toPath(item->data(kPathRole).toString());
        requestThumbnail(image, kThumbnail * devicePixelRatioF(), this,
                         [this, image](const QImage& thumbnail) {
                             QListWidgetItem* shown = itemFor(image);
                             if (shown && !thumbnail.isNull())
                                 shown->setIcon(QIcon(QPixmap::fromImage(thumbnail)));
                         });
    }
}

void EnvironmentPicker::paintEvent(QPaintEvent* event) {
    QWidget::paintEvent(event);
    requestThumbnails();
}

QListWidgetItem* EnvironmentPicker::itemFor(const std::filesystem::path& image) const {
    std::error_code error;
    for (int i = kFirstPicture; i < thumbnails_->count(); ++i) {
        const auto path = toPath(thumbnails_->item(i)->data(kPathRole).toString());
        if (path == image || std::filesystem::equivalent(path, image, error))
            return thumbnails_->item(i);
    }
    return nullptr;
}

void EnvironmentPicker::choose(const std::filesystem::path& image) {
    Scene scene = document_.committed();
    scene.environment.image = assetPath(image, document_.file());
    scene.environment.sky.reset();
    document_.edit(std::move(scene), tr("Environment picture"));
}

void EnvironmentPicker::chooseNone() {
    Scene scene = document_.committed();
    scene.environment.image.clear();
    scene.environment.sky.reset();
    document_.edit(std::move(scene), tr("No environment picture"));
}

void EnvironmentPicker::chooseSky() {
    Scene scene = document_.committed();
    scene.environment.image.clear();
    if (!scene.environment.sky) scene.environment.sky = Sky{};
    document_.edit(std::move(scene), tr("Computed sky"));
}

void EnvironmentPicker::browse() {
    auto* dialog = new QFileDialog(this, tr("Open an environment picture"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilter(tr("Pictures (*.exr *.hdr *.png *.jpg *.jpeg *.tif *.tiff)"));
    connect(dialog, &QFileDialog::fileSelected, this,
            [this](const QString& file) { choose(toPath(file)); });
    dialog->open();
}

void EnvironmentPicker::showCurrent() {
    const std::string& image = document_.scene().environment.image;
    const std::filesystem::path path =
        image.empty() ? std::filesystem::path() : document_.assetFolder() / image;
    if (!image.empty() && !itemFor(path) && std::filesystem::exists(path)) addThumbnail(path);
    const int plainRow = document_.scene().environment.sky ? kSkyRow : kNoneRow;
    QListWidgetItem* current = image.empty() ? thumbnails_->item(plainRow) : itemFor(path);
    if (current == thumbnails_->currentItem()) return;
    thumbnails_->setCurrentItem(current);
}

}  // namespace glint
