// PreviewBall: the traced ball of a material, at the head of its section.
#pragma once

#include <QLabel>

#include "tracer/scene/ids.h"

namespace glint {

class MaterialPreviews;

class PreviewBall : public QLabel {
    Q_OBJECT

  public:
    PreviewBall(MaterialPreviews& previews, MaterialId material, QWidget* parent = nullptr);

  private:
    void showPicture();

    MaterialPreviews& previews_;
    MaterialId material_;
};

}  // namespace glint
