#include "FaceInPupilUnits.h"

#include "CurveDrawing.h"
#include "Failure.h"
#include "PupilNormalisation.h"

namespace mien {

std::vector<QPolygonF> frontalLines(const FaceCurves& face, bool inPupilUnits) {
  PupilNormalisation pupils;
  const std::string fault = pupils.set(face.leftPupil, face.rightPupil);
  if (!fault.empty()) throw FileFailure("the face's curves: " + fault);
  std::vector<QPolygonF> lines;
  for (int curve = 0; curve < face.curves.count; ++curve) {
    lines.push_back(CurveDrawing(face.curves).line(curve));
    for (QPointF& point : lines.back()) {
      const Eigen::Vector3d place = pupils.apply({point.x(), point.y(), 0.0});
      if (inPupilUnits) point = QPointF(place.x(), place.y());
    }
  }
  return lines;
}

void addFaceBehind(PlaneDrawing& drawing, const std::vector<QPolygonF>& lines) {
  for (const QPolygonF& line : lines) drawing.lines.push_back({line, {QColor("#a8a8a8"), 0.35}});
}

}  // namespace mien
