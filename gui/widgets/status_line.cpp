#include "gui/widgets/status_line.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>

#include "gui/app/text.h"
#include "gui/widgets/icons.h"
#include "tracer/compile/render_scene.h"

namespace glint {

namespace {

QString duration(double seconds) {
    const auto whole = static_cast<long long>(seconds);
    if (whole < 60) return StatusLine::tr("%1 s").arg(seconds, 0, 'f', seconds < 10 ? 1 : 0);
    return StatusLine::tr("%1 min %2 s").arg(whole / 60).arg(whole % 60);
}

QString stateText(const SessionFrame& frame) {
    if (frame.state == SessionState::Paused) return StatusLine::tr("paused");
    if (frame.state == SessionState::Converged) return StatusLine::tr("done");
    return frame.spp == 0 ? StatusLine::tr("preview") : QString();
}

/// "± 0.84 %", "± 110 %": two digits that count.
QString errorText(double share) {
    const double percent = 100 * share;
    const int decimals =
        percent > 0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(percent))), 0, 6) : 0;
    return StatusLine::tr("± %1 %").arg(percent, 0, 'f', decimals);
}

/// "41 s, 1 % in 12 s": the time so far, and what is still to come.
QString timeText(const SessionFrame& frame) {
    const QString spent = duration(frame.seconds);
    if (frame.state != SessionState::Rendering || !std::isfinite(frame.remainingSeconds))
        return spent;
    return StatusLine::tr("%1, done in %2").arg(spent, duration(frame.remainingSeconds));
}

/// "glint::Path<2>"-like names and feature lists belong into the tool tip.
QString details(const SessionFrame& frame) {
    QStringList features;
    for (const std::string& feature : frame.features) features << toQString(feature);
    QStringList skips;
    for (const std::string& skip : frame.skips) skips << toQString(skip);
    return StatusLine::tr("Kernel: %1\nThe scene holds: %2\nLeft out: %3")
        .arg(toQString(frame.kernel), features.join(", "), skips.join("; "));
}

}  // namespace

StatusLine::StatusLine(QWidget* parent) : QWidget(parent) {
    state_ = new QLabel(this);
    selection_ = new QLabel(this);
    warningButton_ = new QToolButton(this);
    warningButton_->setIcon(icon("warning"));
    warningButton_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    warningButton_->setAutoRaise(true);
    warningButton_->setToolTip(tr("What the picture cannot show as the scene asks"));
    warningButton_->hide();
    connect(warningButton_, &QToolButton::clicked, this, &StatusLine::openWarnings);
    state_->setMinimumWidth(1);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 0, 8, 0);
    layout->setSpacing(12);
    layout->addWidget(state_, 1);
    layout->addWidget(warningButton_);
    layout->addWidget(selection_);
}

void StatusLine::showFrame(const SessionFrame& frame) {
    QStringList parts;
    const QString state = stateText(frame);
    if (!state.isEmpty()) parts << state;
    parts << (frame.sppTarget > 0 ? tr("%1 / %2 spp").arg(frame.spp).arg(frame.sppTarget)
                                  : tr("%1 spp").arg(frame.spp));
    if (std::isfinite(frame.error)) parts << errorText(frame.error);
    parts << timeText(frame);
    if (frame.filtered) parts << tr("filtered");
    if (frame.region) parts << tr("region");
    if (frame.scene && frame.scene->settings.clamp > 0) parts << tr("clamped, hence biased");
    if (frame.raysPerSecond > 0) parts << tr("%1 Mray/s").arg(frame.raysPerSecond / 1e6, 0, 'f', 1);
    if (!frame.kernel.empty()) parts << toQString(frame.kernel);
    if (frame.nonfiniteSamples > 0)
        parts << tr("%n faulty sample(s)", nullptr, static_cast<int>(frame.nonfiniteSamples));
    stateText_ = parts.join(QStringLiteral("  ·  "));
    errors_ = frame.errors;
    showState();
    state_->setToolTip(details(frame));
    size_ = tr("%1 × %2 px").arg(frame.width).arg(frame.height);
    showSelection(selectionText_);
    showWarnings(frame.warnings);
}

void StatusLine::showPixel(const QPoint& pixel) {
    if (pixel == pixel_) return;
    pixel_ = pixel;
    showState();
}

void StatusLine::showState() {
    QString text = stateText_;
    if (pixel_.x() >= 0 && pixel_.y() >= 0)
        if (const auto error = errors_.at(pixel_.x(), pixel_.y()))
            text += QStringLiteral("  ·  ") +
                    tr("%1 at the pointer").arg(errorText(static_cast<double>(*error)));
    if (text != state_->text()) state_->setText(text);
}

void StatusLine::showSelection(const QString& text) {
    selectionText_ = text;
    selection_->setText(text.isEmpty() ? size_ : text + QStringLiteral("  ·  ") + size_);
}

void StatusLine::showWarnings(const std::vector<Error>& warnings) {
    if (warnings == warnings_) return;
    warnings_ = warnings;
    warningButton_->setVisible(!warnings.empty());
    warningButton_->setText(tr("%n warning(s)", nullptr, static_cast<int>(warnings.size())));
}

void StatusLine::openWarnings() {
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (const Error& warning : warnings_) menu->addAction(toQString(warning))->setEnabled(false);
    menu->popup(warningButton_->mapToGlobal(QPoint(0, -menu->sizeHint().height())));
}

QString StatusLine::text() const { return state_->text(); }

}  // namespace glint
