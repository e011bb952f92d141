#include "gui/viewport/navigation_gestures.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "gui/viewport/navigation.h"
#include "gui/widgets/drag_number.h"

namespace glint {

namespace {

constexpr double kRadiansPerPixel = 0.008, kLookRadiansPerPixel = 0.004,
                 kEnvironmentDegreesPerPixel = 0.25;
constexpr int kFlyIntervalMs = 16;

struct Text {
    Q_DECLARE_TR_FUNCTIONS(NavigationGestures)
};

}  // namespace

DVec3 focusPoint(const ViewContext& context, const QPointF& at) {
    if (const auto surface = context.surfaceAt(at)) return surface->position;
    const ViewProjection view = context.projection();
    const ViewRay ray = view.ray(at);
    const double depth = view.depth(context.document.scene().viewCamera().target);
    return ray.origin + ray.direction * (depth / glm::dot(ray.direction, view.axes().forward));
}

DVec3 orbitCenter(const ViewContext& context, const QPointF& at) {
    const std::vector<Item>& selected = context.selection.items();
    if (!context.navigation.orbitSelection || selected.empty()) return focusPoint(context, at);
    DVec3 sum(0.0);
    for (const Item item : selected)
        sum += worldFromItem(context.document.scene(), item).translation;
    return sum / static_cast<double>(selected.size());
}

CameraGesture::CameraGesture(ViewContext& context, const QPointF& start)
    : Gesture(context), startCamera_(context.document.scene().viewCamera()), start_(start) {}

void CameraGesture::finish(const Pointer&) {
    if (context_.document.scene().viewCamera() != startCamera_)
        context_.history.leave(startCamera_);
}

void CameraGesture::cancel() { context_.document.navigate(startCamera_); }

OrbitGesture::OrbitGesture(ViewContext& context, const QPointF& start)
    : CameraGesture(context, start), pivot_(orbitCenter(context, start)) {}

void OrbitGesture::move(const Pointer& pointer) {
    const QPointF d = pointer.at - start_;
    context_.document.navigate(
        orbited(startCamera_, pivot_, -d.x() * kRadiansPerPixel, -d.y() * kRadiansPerPixel));
}

PanGesture::PanGesture(ViewContext& context, const QPointF& start)
    : CameraGesture(context, start),
      metresPerPixel_(context.projection().metresPerPixel(focusPoint(context, start))) {}

void PanGesture::move(const Pointer& pointer) {
    const QPointF d = (pointer.at - start_) * metresPerPixel_;
    context_.document.navigate(moved(startCamera_, {-d.x(), d.y(), 0}));
}

DollyGesture::DollyGesture(ViewContext& context, const QPointF& start)
    : CameraGesture(context, start), point_(focusPoint(context, start)) {}

void DollyGesture::move(const Pointer& pointer) {
    const QPointF d = pointer.at - start_;
    context_.document.navigate(
        dollied(startCamera_, point_, std::pow(2.0, -(d.x() + d.y()) / 150)));
}

FlyGesture::FlyGesture(ViewContext& context, const QPointF& start)
    : CameraGesture(context, start),
      last_(start),
      metresPerSecond_(
          std::max(0.1, glm::length(startCamera_.target - startCamera_.position) * 0.5)) {
    QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] { advance(); });
}

void FlyGesture::move(const Pointer& pointer) {
    const QPointF d = pointer.at - last_;
    if (!moved_ && d.manhattanLength() < 3) return;
    last_ = pointer.at;
    moved_ = true;
    fast_ = pointer.modifiers & Qt::ShiftModifier;
    context_.document.navigate(turned(context_.document.scene().viewCamera(),
                                      -d.x() * kLookRadiansPerPixel,
                                      -d.y() * kLookRadiansPerPixel));
}

bool FlyGesture::keyPressed(const QKeyEvent& event) {
    fast_ = event.modifiers() & Qt::ShiftModifier;
    static const QSet<int> keys = {Qt::Key_W, Qt::Key_A, Qt::Key_S,
                                   Qt::Key_D, Qt::Key_Q, Qt::Key_E};
    if (!keys.contains(event.key())) return event.key() == Qt::Key_Shift;
    held_.insert(event.key());
    moved_ = true;
    if (!timer_.isActive()) {
        clock_.start();
        timer_.start(kFlyIntervalMs);
    }
    return true;
}

void FlyGesture::keyReleased(const QKeyEvent& event) {
    if (event.key() == Qt::Key_Shift) fast_ = false;
    held_.remove(event.key());
    if (held_.isEmpty()) timer_.stop();
}

bool FlyGesture::wheel(double steps) {
    metresPerSecond_ = std::clamp(metresPerSecond_ * std::pow(1.25, steps), 1e-3, 1e4);
    return true;
}

void FlyGesture::advance() {
    constexpr double kFast = 4, kLongestStep = 0.1;  // seconds: after a stall, do not jump
    const double seconds = std::min(kLongestStep, static_cast<double>(clock_.restart()) / 1000);
    const auto held = [&](int forward, int back) {
        return double(held_.contains(forward)) - double(held_.contains(back));
    };
    const DVec3 direction(held(Qt::Key_D, Qt::Key_A), held(Qt::Key_E, Qt::Key_Q),
                          held(Qt::Key_W, Qt::Key_S));
    if (direction == DVec3(0.0)) return;
    const double step = metresPerSecond_ * (fast_ ? kFast : 1) * seconds;
    context_.document.navigate(
        moved(context_.document.scene().viewCamera(), glm::normalize(direction) * step));
}

QString FlyGesture::readout() const {
    return moved_
               ? Text::tr("Fly: W A S D, Q E · %1 m/s (wheel)").arg(shortNumber(metresPerSecond_))
               : QString();
}

EnvironmentGesture::EnvironmentGesture(ViewContext& context, const QPointF& start)
    : Gesture(context), start_(start) {}

void EnvironmentGesture::move(const Pointer& pointer) {
    Scene scene = context_.document.committed();
    const double turned = scene.environment.rotationDegrees +
                          (pointer.at.x() - start_.x()) * kEnvironmentDegreesPerPixel;
    scene.environment.rotationDegrees = std::remainder(turned, 360.0);
    context_.document.preview(std::move(scene));
}

void EnvironmentGesture::finish(const Pointer&) {
    context_.document.commitPreview(Text::tr("Rotate environment"));
}
void EnvironmentGesture::cancel() { context_.document.cancelPreview(); }

QString EnvironmentGesture::readout() const {
    return Text::tr("Environment %1°")
        .arg(shortNumber(context_.document.scene().environment.rotationDegrees));
}

}  // namespace glint
