// RegionGesture: marks the part of the picture that is rendered.
#pragma once

#include "gui/viewport/gesture.h"

namespace glint {

class RegionGesture : public Gesture {
  public:
    RegionGesture(ViewContext& context, const QPointF& start)
        : Gesture(context), start_(start), last_(start) {}

    void move(const Pointer& pointer) override { last_ = pointer.at; }
    /// A drag sets the region; a click takes it away.
    void finish(const Pointer& pointer) override;
    void cancel() override {}
    void paint(QPainter& painter) const override;
    [[nodiscard]] QString readout() const override;

  private:
    /// Within the picture, as a part of it.
    [[nodiscard]] QRectF region() const;

    QPointF start_, last_;
};

/// The border of a region (a part of the picture) in a view of the given size.
void paintRegion(QPainter& painter, const QRectF& region, const QRectF& view);

}  // namespace glint
