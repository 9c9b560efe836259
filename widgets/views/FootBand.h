#pragma once

#include <QPainter>

#include "Theme.h"

namespace mien {

/// The ground of a key at the foot of a view, with a line between them; on the page of a figure, which is of one
/// colour, without.
inline void paintFoot(QPainter& painter, const QRect& place) {
  const Theme& theme = Theme::current();
  painter.fillRect(place, theme.panel);
  if (theme.panel != theme.viewBottom) painter.fillRect(place.x(), place.y(), place.width(), 1, theme.line);
}

}  // namespace mien
