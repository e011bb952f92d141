// Gestures that move the camera: orbit, pan, dolly, fly; and the one that turns the environment.
#pragma once

#include <QElapsedTimer>
#include <QSet>
#include <QTimer>
#include <memory>

#include "gui/viewport/gesture.h"

namespace glint {

/// Common to all camera drags: one entry in the view history, and Escape goes back.
class CameraGesture : public Gesture {
  public:
    CameraGesture(ViewContext& context, const QPointF& start);
    void finish(const Pointer& pointer) override;
    void cancel() override;

  protected:
    Camera startCamera_;
    QPointF start_;
};

class OrbitGesture : public CameraGesture {
  public:
    /// Turns about what is under the pointer.
    OrbitGesture(ViewContext& context, const QPointF& start);
    void move(const Pointer& pointer) override;

  private:
    DVec3 pivot_;
};

class PanGesture : public CameraGesture {
  public:
    PanGesture(ViewContext& context, const QPointF& start);
    void move(const Pointer& pointer) override;

  private:
    double metresPerPixel_;
};

class DollyGesture : public CameraGesture {
  public:
    DollyGesture(ViewContext& context, const QPointF& start);
    void move(const Pointer& pointer) override;

  private:
    DVec3 point_;
};

/// Right button held: the mouse looks around, W A S D Q E move.
class FlyGesture : public CameraGesture {
  public:
    FlyGesture(ViewContext& context, const QPointF& start);
    void move(const Pointer& pointer) override;
    bool keyPressed(const QKeyEvent& event) override;
    void keyReleased(const QKeyEvent& event) override;
    bool wheel(double steps) override;
    [[nodiscard]] QString readout() const override;
    /// Neither turned nor moved yet: a plain click.
    [[nodiscard]] bool isClick() const { return !moved_; }

  private:
    void advance();

    QPointF last_;
    QSet<int> held_;
    QTimer timer_;
    QElapsedTimer clock_;
    double metresPerSecond_;
    bool fast_ = false, moved_ = false;
};

/// Turns the environment about the upward axis. An edit: one undo step.
class EnvironmentGesture : public Gesture {
  public:
    EnvironmentGesture(ViewContext& context, const QPointF& start);
    void move(const Pointer& pointer) override;
    void finish(const Pointer& pointer) override;
    void cancel() override;
    [[nodiscard]] QString readout() const override;

  private:
    QPointF start_;
};

/// The point that a wheel or drag at `at` goes about: the surface there, else at the depth of the
/// camera's target.
[[nodiscard]] DVec3 focusPoint(const ViewContext& context, const QPointF& at);
/// The point that an orbit begun at a pixel turns about: as the person likes it, see
/// NavigationOptions.
[[nodiscard]] DVec3 orbitCenter(const ViewContext& context, const QPointF& at);

}  // namespace glint
