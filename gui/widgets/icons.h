// The program's icons: SVG drawings in one colour that is replaced by the palette's, so they follow
// theme and state.
#pragma once

#include <QColor>
#include <QIcon>
#include <QRectF>
#include <QString>

class QPainter;

namespace glint {

/// The icon `resources/icons/<name>.svg`. Sharp at any size; drawn in the text colour, in the
/// highlight colour when on.
[[nodiscard]] QIcon icon(const QString& name);

/// Draws the icon in a colour of its own, for use on a picture.
void drawIcon(QPainter& painter, const QString& name, const QRectF& rect, const QColor& color);

}  // namespace glint
