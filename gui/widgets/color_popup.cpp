#include "gui/widgets/color_popup.h"

#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "gui/widgets/color_button.h"
#include "gui/widgets/drag_number.h"
#include "gui/widgets/hue_square.h"
#include "gui/widgets/icons.h"
#include "tracer/color/display.h"

namespace glint {

namespace {

Color linearColor(const QColor& screen) {
    return {linearFromSrgb(screen.redF()), linearFromSrgb(screen.greenF()),
            linearFromSrgb(screen.blueF())};
}

double peakOf(const Color& c) { return std::max({c.r, c.g, c.b}); }

Color scaled(const Color& c, double factor) { return {c.r * factor, c.g * factor, c.b * factor}; }

}  // namespace

ColorPopup::ColorPopup(double min, double max, QWidget* parent)
    : QFrame(parent, Qt::Popup), max_(max) {
    setFrameShape(QFrame::StyledPanel);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    square_ = new HueSquare(this);
    layout->addWidget(square_);
    buildNumbers(min, max);
    connect(square_, &HueSquare::picked, this,
            [this](const QColor& c) { emit previewed(withBrightness(c)); });
    connect(square_, &HueSquare::released, this,
            [this](const QColor& c) { emit edited(withBrightness(c)); });
}

void ColorPopup::buildNumbers(double min, double max) {
    auto* form = new QFormLayout;
    form->setVerticalSpacing(4);
    const QString names[] = {tr("Red"), tr("Green"), tr("Blue")};
    double Color::*const members[] = {&Color::r, &Color::g, &Color::b};
    for (int i = 0; i < 3; ++i) {
        auto* number = channels_[i] = new DragNumber(this);
        number->setRange({.min = min, .max = max});
        number->setObjectName(QStringLiteral("channel%1").arg(i));
        number->setAccessibleName(names[i]);
        const auto member = members[i];
        const auto with = [this, member](double v) {
            Color color = value_;
            color.*member = v;
            return color;
        };
        connect(number, &DragNumber::previewed, this,
                [this, with](double v) { emit previewed(with(v)); });
        connect(number, &DragNumber::edited, this,
                [this, with](double v) { emit edited(with(v)); });
        connect(number, &DragNumber::canceled, this, &ColorPopup::canceled);
        form->addRow(names[i], number);
        number->setToolTip(tr("Linear Rec.709"));
    }
    brightness_ = new DragNumber(this);
    brightness_->setRange({.min = 0, .max = max});
    brightness_->setAccessibleName(tr("Brightness"));
    brightness_->setToolTip(tr("The largest channel; the others keep their ratio to it"));
    const auto brighter = [this](double v) {
        const double peak = peakOf(value_);
        return peak > 0 ? scaled(value_, v / peak) : Color{v, v, v};
    };
    connect(brightness_, &DragNumber::previewed, this,
            [this, brighter](double v) { emit previewed(brighter(v)); });
    connect(brightness_, &DragNumber::edited, this,
            [this, brighter](double v) { emit edited(brighter(v)); });
    connect(brightness_, &DragNumber::canceled, this, &ColorPopup::canceled);
    form->addRow(tr("Brightness"), brightness_);
    hex_ = new QLineEdit(this);
    hex_->setObjectName("hex");
    hex_->setToolTip(tr("As in other programs: #rrggbb in sRGB, not linear"));
    hex_->setAccessibleName(tr("Hex (sRGB)"));
    connect(hex_, &QLineEdit::returnPressed, this, &ColorPopup::onHex);
    form->addRow(tr("Hex (sRGB)"), hex_);
    auto* dropper = new QPushButton(icon("dropper"), tr("Pick from the picture"), this);
    dropper->setObjectName("dropper");
    dropper->setToolTip(
        tr("The next click on the picture takes its linear colour, as it is before the exposure; "
           "Esc ends it"));
    connect(dropper, &QPushButton::clicked, this, &ColorPopup::dropperRequested);
    form->addRow(dropper);
    static_cast<QVBoxLayout*>(layout())->addLayout(form);
}

void ColorPopup::setValue(const Color& color) {
    value_ = color;
    const double channels[] = {color.r, color.g, color.b};
    for (int i = 0; i < 3; ++i) channels_[i]->setValue(channels[i]);
    brightness_->setValue(peakOf(color));
    square_->setColor(screenColor(color));
    hex_->setText(screenColor(color).name());
}

void ColorPopup::onHex() {
    QString text = hex_->text().trimmed();
    if (!text.startsWith('#')) text.prepend('#');
    if (!QColor::isValidColor(text)) {
        hex_->setText(screenColor(value_).name());
        return;
    }
    emit edited(linearColor(QColor(text)));
}

Color ColorPopup::withBrightness(const QColor& color) const {
    const Color linear = linearColor(color);
    const double above = std::max(1.0, peakOf(value_));
    return std::isinf(max_) ? scaled(linear, above) : linear;
}

}  // namespace glint
