#include "gui/widgets/preview_ball.h"

#include "gui/app/material_previews.h"

namespace glint {

PreviewBall::PreviewBall(MaterialPreviews& previews, MaterialId material, QWidget* parent)
    : QLabel(parent), previews_(previews), material_(material) {
    setAccessibleName(tr("Preview"));
    setAlignment(Qt::AlignCenter);
    setMinimumHeight(MaterialPreviews::kSide + 8);
    connect(&previews, &MaterialPreviews::changed, this, [this](MaterialId changed) {
        if (changed == material_) showPicture();
    });
    previews.hurry(material);
    showPicture();
}

void PreviewBall::showPicture() {
    QPixmap picture = QPixmap::fromImage(previews_.of(material_));
    if (picture.isNull()) return;
    const int side = static_cast<int>(MaterialPreviews::kSide * devicePixelRatioF());
    if (side != picture.width())
        picture = picture.scaled(side, side, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    picture.setDevicePixelRatio(devicePixelRatioF());
    setPixmap(picture);
}

}  // namespace glint
