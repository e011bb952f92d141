// Eyedropper: the next click on a picture takes its colour; any other click or Esc ends it.
#pragma once

#include <QObject>
#include <QPoint>
#include <functional>

#include "tracer/color/rgb.h"

namespace glint {

/// A widget that shows linear light.
class PictureSource {
  public:
    virtual ~PictureSource() = default;
    /// Tells the linear light (Rec.709) of the pixel at a point of the screen, before the exposure,
    /// as soon as it is known. False outside the picture: then nothing is told.
    virtual bool tellColor(const QPoint& global, std::function<void(const Color&)> tell) = 0;
};

class Eyedropper : public QObject {
    Q_OBJECT

  public:
    explicit Eyedropper(QObject* parent = nullptr);
    ~Eyedropper() override;

    bool eventFilter(QObject* watched, QEvent* event) override;

  signals:
    void picked(const glint::Color& color);

  private:
    /// Sees no more events. What was clicked may still be about to be told.
    void end();

    bool ended_ = false;
};

}  // namespace glint
