#include "gui/app/export_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "gui/app/document.h"
#include "gui/app/text.h"
#include "gui/widgets/drag_number.h"
#include "gui/widgets/icons.h"
#include "tracer/io/image_file.h"

namespace glint {

namespace {

struct SizePreset {
    const char* name;
    int width, height;
};
#define T(text) QT_TRANSLATE_NOOP("ExportDialog", text)
constexpr SizePreset kPresets[] = {{T("HD"), 1280, 720},        {T("Full HD"), 1920, 1080},
                                   {T("4K UHD"), 3840, 2160},   {T("Square"), 1080, 1080},
                                   {T("Portrait"), 1080, 1350}, {T("A4 at 300 dpi"), 3508, 2480}};
constexpr const char* kFormats[] = {".png", ".jpg", ".tif", ".exr", ".hdr"};
#undef T

int whole(const DragNumber* number) {
    return static_cast<int>(std::lround(number->value().value_or(1)));
}

QString sizeText(int width, int height) { return QStringLiteral("%1 × %2").arg(width).arg(height); }

QWidget* rowOf(const std::vector<QWidget*>& widgets) {
    auto* out = new QWidget;
    auto* layout = new QHBoxLayout(out);
    layout->setContentsMargins(0, 0, 0, 0);
    for (QWidget* widget : widgets)
        layout->addWidget(widget, qobject_cast<QToolButton*>(widget) ? 0 : 1);
    return out;
}

}  // namespace

ExportDialog::ExportDialog(const Document& document, QWidget* parent)
    : QDialog(parent), document_(document) {
    setWindowTitle(tr("Export picture"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* form = new QFormLayout(this);
    buildFile(form);
    buildSize(form);
    buildStop(form);
    buildContent(form);
    buildRegion(form);
    buildTurntable(form);
    hint_ = new QLabel(this);
    hint_->setObjectName("export.hint");
    hint_->setWordWrap(true);
    form->addRow(hint_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    start_ = buttons->addButton(tr("Export"), QDialogButtonBox::AcceptRole);
    start_->setObjectName("export.start");
    start_->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &ExportDialog::start);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    form->addRow(buttons);
    takeFormat();
}

DragNumber* ExportDialog::makeNumber(const QString& name, const QString& label, double value,
                                     const NumberRange& range, const QString& unit) {
    auto* number = new DragNumber(this);
    number->setObjectName(name);
    number->setAccessibleName(label);
    number->setToolTip(label);
    number->setRange(range);
    number->setUnit(unit);
    number->setValue(value);
    const auto take = [this, number](double v) {
        number->setValue(v);
        refresh();
    };
    connect(number, &DragNumber::edited, this, take);
    connect(number, &DragNumber::previewed, this, take);
    return number;
}

void ExportDialog::buildFile(QFormLayout* form) {
    path_ = new QLineEdit(this);
    path_->setObjectName("export.path");
    path_->setAccessibleName(tr("File"));
    path_->setMinimumWidth(fontMetrics().averageCharWidth() * 44);
    const auto stem = document_.file().empty() ? std::filesystem::path("picture")
                                               : document_.file().stem().stem();
    path_->setText(pathText(document_.assetFolder() / (stem.string() + ".png")));
    path_->setToolTip(tr("The ending chooses the format"));
    connect(path_, &QLineEdit::textChanged, this, &ExportDialog::takeFormat);
    auto* browseButton = new QPushButton(tr("Browse…"), this);
    browseButton->setAutoDefault(false);
    connect(browseButton, &QPushButton::clicked, this, &ExportDialog::browse);
    auto* row = new QHBoxLayout;
    row->addWidget(path_, 1);
    row->addWidget(browseButton);
    form->addRow(tr("File"), row);

    format_ = new QComboBox(this);
    format_->setObjectName("export.format");
    format_->setAccessibleName(tr("Format"));
    const QString names[] = {tr("PNG, for the screen"), tr("JPEG, small"),
                             tr("TIFF, for the screen"), tr("OpenEXR, linear light"),
                             tr("Radiance HDR, linear light")};
    for (std::size_t i = 0; i < std::size(kFormats); ++i)
        format_->addItem(names[i], QString::fromLatin1(kFormats[i]));
    connect(format_, &QComboBox::activated, this, [this] {
        std::filesystem::path path = toPath(path_->text());
        path.replace_extension(format_->currentData().toString().toStdString());
        path_->setText(pathText(path));
    });
    bits_ = new QComboBox(this);
    bits_->setObjectName("export.bits");
    bits_->setAccessibleName(tr("Bits a channel"));
    bits_->setToolTip(bits_->accessibleName());
    form->addRow(tr("Format"), rowOf({format_, bits_}));
}

void ExportDialog::buildSize(QFormLayout* form) {
    const FilmSettings& film = document_.scene().film;
    aspect_ = static_cast<double>(film.width) / film.height;
    preset_ = new QComboBox(this);
    preset_->setObjectName("export.preset");
    preset_->setAccessibleName(tr("Size"));
    preset_->addItem(tr("As the scene says, %1").arg(sizeText(film.width, film.height)),
                     QSize(film.width, film.height));
    for (const SizePreset& preset : kPresets)
        preset_->addItem(
            QStringLiteral("%1, %2").arg(tr(preset.name), sizeText(preset.width, preset.height)),
            QSize(preset.width, preset.height));
    connect(preset_, &QComboBox::activated, this, &ExportDialog::takePreset);
    const NumberRange side{.min = 1, .max = 65536, .integer = true};
    width_ = makeNumber("export.width", tr("Width"), film.width, side, "px");
    height_ = makeNumber("export.height", tr("Height"), film.height, side, "px");
    lock_ = new QToolButton(this);
    lock_->setObjectName("export.lock");
    lock_->setCheckable(true);
    lock_->setChecked(true);
    lock_->setAutoRaise(true);
    lock_->setIcon(icon("lock"));
    lock_->setToolTip(tr("Keep the ratio of width and height"));
    lock_->setAccessibleName(lock_->toolTip());
    connect(lock_, &QToolButton::toggled, this, [this](bool on) {
        lock_->setIcon(icon(on ? "lock" : "unlock"));
        aspect_ = static_cast<double>(whole(width_)) / whole(height_);
    });
    connect(width_, &DragNumber::edited, this, [this] { takeSide(width_, height_, 1 / aspect_); });
    connect(height_, &DragNumber::edited, this, [this] { takeSide(height_, width_, aspect_); });
    percent_ =
        makeNumber("export.percent", tr("Percent of that size"), 100, {.min = 1, .max = 1000}, "%");
    form->addRow(tr("Size"), preset_);
    form->addRow(QString(), rowOf({width_, lock_, height_, percent_}));
}

void ExportDialog::takeSide(DragNumber* changed, DragNumber* other, double ratio) {
    if (lock_->isChecked())
        other->setValue(std::clamp(std::round(whole(changed) * ratio), 1.0, 65536.0));
    refresh();
}

void ExportDialog::takePreset(int index) {
    const QSize size = preset_->itemData(index).toSize();
    width_->setValue(size.width());
    height_->setValue(size.height());
    aspect_ = static_cast<double>(size.width()) / size.height();
    refresh();
}

void ExportDialog::buildStop(QFormLayout* form) {
    const RenderSettings& render = document_.scene().render;
    spp_ = makeNumber("export.spp", tr("Samples a pixel to stop at"), render.spp,
                      {.min = 1, .max = 16777216, .integer = true}, "spp");
    time_ = makeNumber("export.time", tr("Time to stop at; 0 is no limit"), render.timeSeconds,
                       {.min = 0}, "s");
    error_ = makeNumber("export.error", tr("Error of the picture to stop at; 0 is no limit"),
                        render.errorPercent, {.min = 0, .max = 100}, "%");
    auto label = [this](const QString& text) {
        auto* out = new QLabel(text, this);
        out->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        return out;
    };
    form->addRow(tr("Stop at"),
                 rowOf({spp_, label(tr("time")), time_, label(tr("error")), error_}));
}

void ExportDialog::buildContent(QFormLayout* form) {
    transparent_ = new QCheckBox(tr("Transparent background"), this);
    transparent_->setObjectName("export.transparent");
    transparent_->setToolTip(tr("An alpha channel instead of the environment behind the objects"));
    layers_ = new QCheckBox(tr("Layers"), this);
    layers_->setObjectName("export.layers");
    layers_->setToolTip(
        tr("Light by kind, albedo, normal, depth, position, ids, sample count and error beside the "
           "picture"));
    for (QCheckBox* box : {transparent_, layers_})
        connect(box, &QCheckBox::toggled, this, &ExportDialog::refresh);
    form->addRow(tr("Content"), rowOf({transparent_, layers_}));
}

QCheckBox* ExportDialog::addSwitched(QFormLayout* form, const QString& name, const QString& label,
                                     const std::vector<QWidget*>& fields) {
    auto* box = new QCheckBox(label, this);
    box->setObjectName(name);
    QWidget* row = rowOf(fields);
    row->setEnabled(false);
    connect(box, &QCheckBox::toggled, row, &QWidget::setEnabled);
    connect(box, &QCheckBox::toggled, this, &ExportDialog::refresh);
    form->addRow(box, row);
    return box;
}

void ExportDialog::buildRegion(QFormLayout* form) {
    const FilmSettings& film = document_.scene().film;
    const NumberRange from{.min = 0, .max = 65535, .integer = true},
        size{.min = 1, .max = 65536, .integer = true};
    x_ = makeNumber("export.region.x", tr("Left edge"), 0, from, "px");
    y_ = makeNumber("export.region.y", tr("Upper edge"), 0, from, "px");
    regionWidth_ =
        makeNumber("export.region.width", tr("Width of the part"), film.width, size, "px");
    regionHeight_ =
        makeNumber("export.region.height", tr("Height of the part"), film.height, size, "px");
    region_ = addSwitched(form, "export.region", tr("Only a part"),
                          {x_, y_, regionWidth_, regionHeight_});
}

void ExportDialog::buildTurntable(QFormLayout* form) {
    const Turntable usual;
    frames_ = makeNumber("export.turntable.frames", tr("Number of pictures"), usual.frames,
                         {.min = 1, .max = 100000, .integer = true}, {});
    degrees_ = makeNumber("export.turntable.degrees", tr("Turn over all pictures"), usual.degrees,
                          {}, "deg");
    axis_ = new QComboBox(this);
    axis_->setObjectName("export.turntable.axis");
    axis_->setAccessibleName(tr("Axis to turn about, through the camera's target"));
    axis_->setToolTip(axis_->accessibleName());
    axis_->addItems({"x", "y", "z"});
    axis_->setCurrentIndex(usual.axis);
    connect(axis_, &QComboBox::activated, this, &ExportDialog::refresh);
    turntable_ = addSwitched(form, "export.turntable", tr("Turntable"), {frames_, axis_, degrees_});
}

void ExportDialog::browse() {
    auto* dialog = new QFileDialog(this, tr("Export picture"), path_->text());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    QStringList patterns;
    for (const std::string& ending : writableEndings()) patterns << "*" + toQString(ending);
    dialog->setNameFilter(tr("Pictures (%1)").arg(patterns.join(' ')));
    connect(dialog, &QFileDialog::fileSelected, path_, &QLineEdit::setText);
    dialog->open();
}

void ExportDialog::takeFormat() {
    const std::filesystem::path path = toPath(path_->text());
    std::string ending = toQString(path.extension().string()).toLower().toStdString();
    if (ending == ".jpeg") ending = ".jpg";
    if (ending == ".tiff") ending = ".tif";
    format_->setCurrentIndex(format_->findData(toQString(ending)));
    const int before = bits_->currentData().toInt();
    bits_->clear();
    for (const int bits : bitDepths(path)) bits_->addItem(tr("%1 bits").arg(bits), bits);
    if (const int again = bits_->findData(before); again >= 0) bits_->setCurrentIndex(again);
    refresh();
}

ExportRequest ExportDialog::request() const {
    ExportRequest out{
        document_.committed(), document_.assetFolder(), toPath(path_->text()), {}, {}};
    const double scale = percent_->value().value_or(100) / 100;
    const auto scaled = [&](const DragNumber* number) {
        return std::clamp(static_cast<int>(std::lround(whole(number) * scale)), 1, 65536);
    };
    out.scene.film.width = scaled(width_);
    out.scene.film.height = scaled(height_);
    out.scene.render.spp = whole(spp_);
    out.scene.render.timeSeconds = time_->value().value_or(0);
    out.scene.render.errorPercent = error_->value().value_or(0);
    out.picture.bits = bits_->currentData().toInt();
    out.picture.transparent = transparent_->isChecked() && transparent_->isEnabled();
    out.picture.layers = layers_->isChecked() && layers_->isEnabled();
    if (region_->isChecked())
        out.picture.crop =
            PixelRect{whole(x_), whole(y_), whole(regionWidth_), whole(regionHeight_)};
    if (turntable_->isChecked())
        out.turntable =
            Turntable{whole(frames_), axis_->currentIndex(), degrees_->value().value_or(360)};
    return out;
}

QString ExportDialog::problem(const ExportRequest& request) const {
    if (const Status good = checkPicture(request.output, request.picture); !good)
        return toQString(good.error());
    const FilmSettings& film = request.scene.film;
    if (const auto& crop = request.picture.crop;
        crop && (crop->width > film.width - crop->x || crop->height > film.height - crop->y))
        return tr("The part reaches out of the picture of %1 pixels")
            .arg(sizeText(film.width, film.height));
    std::error_code code;
    const auto folder = std::filesystem::absolute(request.output).parent_path();
    if (!std::filesystem::is_directory(folder, code))
        return tr("There is no folder %1").arg(pathText(folder));
    return {};
}

void ExportDialog::refresh() {
    if (!start_) return;  // Still being built.
    const std::filesystem::path path = toPath(path_->text());
    transparent_->setEnabled(holdsAlpha(path));
    layers_->setEnabled(isLinearFormat(path) && holdsAlpha(path));
    bits_->setEnabled(bits_->count() > 1);
    const ExportRequest asked = request();
    const QString wrong = problem(asked);
    QString text = wrong;
    if (text.isEmpty()) {
        text = tr("%1 pixels").arg(sizeText(asked.scene.film.width, asked.scene.film.height));
        const auto first = asked.turntable ? numbered(asked.output, 0) : asked.output;
        if (asked.turntable)
            text += tr(" · %n picture(s): %1 …", nullptr, asked.turntable->frames)
                        .arg(pathText(first.filename()));
        if (std::error_code code; std::filesystem::exists(first, code))
            text += tr(" · replaces the file that is there");
    }
    hint_->setText(text);
    hint_->setProperty("level", wrong.isEmpty() ? QString() : QStringLiteral("error"));
    start_->setEnabled(wrong.isEmpty());
}

void ExportDialog::start() {
    const ExportRequest asked = request();
    if (!problem(asked).isEmpty()) return;
    emit requested(asked);
    accept();
}

}  // namespace glint
