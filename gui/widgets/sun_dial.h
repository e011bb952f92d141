// SunDial: the dome of the sky from above, with the sun to drag. The middle is the zenith, the rim
// the horizon.
#pragma once

#include "gui/widgets/dial.h"
#include "tracer/math/types.h"

namespace glint {

/// Degrees: azimuth clockwise from -z (away from a viewer who looks along -z) as seen from above,
/// elevation above the horizon.
struct SunAngles {
    double azimuth = 0, elevation = 45;
};
/// Of a direction of any length; y is up.
[[nodiscard]] SunAngles sunAngles(const DVec3& direction);
/// Unit vector towards the sun.
[[nodiscard]] DVec3 sunDirection(const SunAngles& angles);

class SunDial : public Dial {
    Q_OBJECT

  public:
    explicit SunDial(QWidget* parent = nullptr);

    void setValue(const SunAngles& angles);

  signals:
    void previewed(const glint::SunAngles& angles);
    void edited(const glint::SunAngles& angles);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void grab(const QPointF& at) override;
    void drag(const QPointF& at, bool fine) override;
    void drop() override;
    void nudge(double right, double up) override;

  private:
    [[nodiscard]] double radius() const;
    [[nodiscard]] SunAngles anglesAt(const QPointF& at) const;

    SunAngles value_, dragged_;
};

}  // namespace glint
