#include "FaceLines.h"

#include "BoundaryCurveData.h"
#include "Failure.h"
#include "PupilNormalisation.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace mien {

namespace {

constexpr double furthestBack = -1.6;  // z of what is still seen from the front, pupil units

}  // namespace

std::vector<QPolygonF> genericFaceLines(const FacialRegions& regions) {
  vtkNew<vtkBoundaryCurveReader> reader;
  reader->Update();
  FaceCurves face;
  PupilNormalisation pupils;
  std::string fault = readFaceCurves(reader->GetOutput(), face);
  if (fault.empty()) fault = pupils.set(face.leftPupil, face.rightPupil);
  if (!fault.empty()) throw FileFailure("generic face: " + fault);
  std::vector<QPolygonF> lines;
  const int count = face.curves.pointsPerCurve;
  for (int curve = 0; curve < face.curves.count; ++curve) {
    bool open = false;
    for (int i = 0; i <= count; ++i) {
      const Eigen::Vector3d point = pupils.apply(face.curves.curve(curve).row(i % count).transpose());
      const bool seen = point.z() > furthestBack && regions.outlineWeight(point.head<2>()) > 0.5;
      if (seen && !open) lines.emplace_back();
      if (seen) lines.back() << QPointF(point.x(), point.y());
      open = seen;
    }
  }
  return lines;
}

}  // namespace mien
