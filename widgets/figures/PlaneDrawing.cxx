#include "PlaneDrawing.h"

namespace mien {

QRectF PlaneDrawing::bounds() const {
  QPolygonF all;
  for (const Line& line : lines) all += line.points;
  for (const Mark& mark : marks) all << mark.at;
  return all.boundingRect();
}

}  // namespace mien
