#include "gui/panels/statistics_panel.h"

#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <cmath>

#include "gui/app/document.h"
#include "gui/app/renderer.h"
#include "gui/app/text.h"

namespace glint {

namespace {

QString count(std::size_t n) { return QLocale().toString(static_cast<qulonglong>(n)); }

}  // namespace

StatisticsPanel::StatisticsPanel(const Document& document, const Renderer& renderer,
                                 QWidget* parent)
    : QWidget(parent), document_(document), renderer_(renderer) {
    setAccessibleName(tr("Statistics"));
    auto* form = new QFormLayout(this);
    form->setContentsMargins(12, 8, 12, 8);
    form->setHorizontalSpacing(16);
    form->setVerticalSpacing(4);
    objects_ = addRow(form, tr("Objects"));
    groups_ = addRow(form, tr("Groups"));
    lights_ = addRow(form, tr("Lights"));
    materials_ = addRow(form, tr("Materials"));
    cameras_ = addRow(form, tr("Cameras"));
    size_ = addRow(form, tr("Picture"));
    samples_ = addRow(form, tr("Samples a pixel"));
    time_ = addRow(form, tr("Time"));
    error_ = addRow(form, tr("Error of the picture"));
    rays_ = addRow(form, tr("Rays a second"));
    kernel_ = addRow(form, tr("Kernel"));
    features_ = addRow(form, tr("The scene holds"));
    faulty_ = addRow(form, tr("Faulty samples"));
    features_->setWordWrap(true);
    connect(&document, &Document::changed, this, [this] {
        if (isVisible()) showScene();
    });
    connect(&renderer, &Renderer::frameReady, this, [this] {
        if (isVisible()) showFrame();
    });
}

QLabel* StatisticsPanel::addRow(QFormLayout* form, const QString& name) {
    auto* value = new QLabel(QStringLiteral("—"), this);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    value->setAccessibleName(name);
    auto* title = new QLabel(name, this);
    title->setEnabled(false);
    form->addRow(title, value);
    return value;
}

void StatisticsPanel::showScene() {
    const Scene& scene = document_.scene();
    objects_->setText(count(scene.objects.size()));
    groups_->setText(count(scene.groups.size()));
    lights_->setText(count(scene.lights.size()));
    materials_->setText(count(scene.materials.size()));
    cameras_->setText(count(scene.cameras.size() + 1));
}

void StatisticsPanel::showFrame() {
    const SessionFrame* frame = renderer_.frame();
    if (!frame) return;
    size_->setText(tr("%1 × %2 px").arg(frame->width).arg(frame->height));
    samples_->setText(tr("%1 of %2").arg(frame->spp).arg(frame->sppTarget));
    time_->setText(tr("%1 s").arg(frame->seconds, 0, 'f', 1));
    error_->setText(std::isfinite(frame->error) ? tr("± %1 %").arg(100 * frame->error, 0, 'g', 2)
                                                : QStringLiteral("—"));
    rays_->setText(tr("%1 million").arg(frame->raysPerSecond / 1e6, 0, 'f', 1));
    kernel_->setText(toQString(frame->kernel));
    QStringList features;
    for (const std::string& feature : frame->features) features << toQString(feature);
    features_->setText(features.isEmpty() ? QStringLiteral("—") : features.join(", "));
    faulty_->setText(count(frame->nonfiniteSamples));
}

void StatisticsPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    showScene();
    showFrame();
}

}  // namespace glint
