// What a channel of the picture shows: its name, and the scale of its false colours.
#pragma once

#include <QPainter>

#include "tracer/render/session.h"

namespace glint {

/// For menus and the legend.
[[nodiscard]] QString channelName(Channel channel);

/// In the lower left corner of the view.
void paintLegend(QPainter& painter, const SessionFrame& frame, const QRectF& view);

}  // namespace glint
