#include "gui/panels/environment_dials.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <cmath>

#include "gui/app/document.h"
#include "gui/widgets/angle_dial.h"
#include "gui/widgets/drag_number.h"

namespace glint {

EnvironmentDials::EnvironmentDials(Document& document, QWidget* parent)
    : QWidget(parent), document_(document) {
    rotation_ = new AngleDial(this);
    rotation_->setObjectName("environment.dial");
    rotation_->setAccessibleName(tr("Turn of the environment"));
    rotation_->setToolTip(
        tr("Drag to turn the environment, Shift for fine steps.\nIn the picture: Shift, then drag "
           "with the right button"));
    rotationText_ = new QLabel(this);
    rotationText_->setAlignment(Qt::AlignCenter);
    auto* turnColumn = new QVBoxLayout;
    turnColumn->setSpacing(2);
    turnColumn->addWidget(rotation_, 0, Qt::AlignHCenter);
    turnColumn->addWidget(rotationText_);
    turnColumn->addStretch();
    buildSun();
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 4, 8, 4);
    row->setSpacing(12);
    row->addLayout(turnColumn);
    row->addWidget(sunBox_);
    row->addStretch();
    connect(rotation_, &AngleDial::previewed, this, [this](double v) { turn(v, false); });
    connect(rotation_, &AngleDial::edited, this, [this](double v) { turn(v, true); });
    for (Dial* dial : std::initializer_list<Dial*>{rotation_, sun_})
        connect(dial, &Dial::canceled, this, [this] { document_.cancelPreview(); });
    connect(&document, &Document::changed, this, &EnvironmentDials::showScene);
    showScene();
}

void EnvironmentDials::buildSun() {
    sunBox_ = new QWidget(this);
    sun_ = new SunDial(sunBox_);
    sun_->setObjectName("environment.sun");
    sun_->setAccessibleName(tr("Place of the sun"));
    sun_->setToolTip(tr("Drag the sun: the middle is overhead, the rim is the horizon"));
    const auto number = [this](const QString& name, const QString& label, const QString& tip,
                               double min, double max) {
        auto* field = new DragNumber(sunBox_);
        field->setObjectName(name);
        field->setAccessibleName(label);
        field->setToolTip(tip);
        field->setUnit("deg");
        field->setRange({.min = min, .max = max});
        return field;
    };
    azimuth_ = number("environment.azimuth", tr("Azimuth"),
                      tr("Direction of the sun, clockwise from −z seen from above"), -3600, 3600);
    elevation_ = number("environment.elevation", tr("Elevation"),
                        tr("Height of the sun above the horizon"), -90, 90);
    auto* form = new QFormLayout;
    form->setVerticalSpacing(4);
    form->addRow(azimuth_->accessibleName(), azimuth_);
    form->addRow(elevation_->accessibleName(), elevation_);
    auto* column = new QVBoxLayout(sunBox_);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addWidget(sun_, 0, Qt::AlignHCenter);
    column->addLayout(form);
    connect(sun_, &SunDial::previewed, this, [this](const SunAngles& a) { placeSun(a, false); });
    connect(sun_, &SunDial::edited, this, [this](const SunAngles& a) { placeSun(a, true); });
    for (DragNumber* field : {azimuth_, elevation_}) {
        const bool isAzimuth = field == azimuth_;
        const auto with = [this, isAzimuth](double v) {
            const auto& sky = document_.scene().environment.sky;
            SunAngles angles = sunAngles(sky ? sky->sunDirection : DVec3(0, 1, 0));
            (isAzimuth ? angles.azimuth : angles.elevation) = v;
            return angles;
        };
        connect(field, &DragNumber::previewed, this,
                [this, with](double v) { placeSun(with(v), false); });
        connect(field, &DragNumber::edited, this,
                [this, with](double v) { placeSun(with(v), true); });
        connect(field, &DragNumber::canceled, this, [this] { document_.cancelPreview(); });
    }
}

void EnvironmentDials::showScene() {
    const Environment& environment = document_.scene().environment;
    rotation_->setValue(environment.rotationDegrees);
    rotationText_->setText(tr("%1°").arg(shortNumber(environment.rotationDegrees)));
    sunBox_->setVisible(environment.sky.has_value());
    if (!environment.sky) return;
    const SunAngles angles = sunAngles(environment.sky->sunDirection);
    sun_->setValue(angles);
    azimuth_->setValue(std::round(angles.azimuth * 10) / 10);
    elevation_->setValue(std::round(angles.elevation * 10) / 10);
}

void EnvironmentDials::turn(double degrees, bool done) {
    Scene scene = document_.committed();
    scene.environment.rotationDegrees = degrees;
    if (done)
        document_.edit(std::move(scene), tr("Turn environment"));
    else
        document_.preview(std::move(scene));
}

void EnvironmentDials::placeSun(const SunAngles& angles, bool done) {
    Scene scene = document_.committed();
    if (!scene.environment.sky) return;
    scene.environment.sky->sunDirection = sunDirection(angles);
    if (done)
        document_.edit(std::move(scene), tr("Move sun"));
    else
        document_.preview(std::move(scene));
}

}  // namespace glint
