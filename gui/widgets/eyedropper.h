// Eyedropper: the next click on a picture takes its colour; any other click or Esc ends it.
#pragma once

#include <QObject>
#include <QPoint>
#include <optional>

#include "tracer/color/rgb.h"

namespace glint {

/// A widget that shows linear light.
class PictureSource {
  public:
    virtual ~PictureSource() = default;
    /// Linear Rec.709 of the pixel at a point of the screen, before the exposure; none outside the picture.
    [[nodiscard]] virtual std::optional<Color> colorAt(const QPoint& global) const = 0;
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
    void end();
};

}  // namespace glint
