#include "FaceLines.h"

#include "BoundaryCurveData.h"
#include "Failure.h"
#include "LandmarkLines.h"
#include "PupilNormalisation.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace mien {

namespace {

/// The parts of a line, a row for each point in mm, that are seen within the face's outline.
void addSeen(const ClosedCurves::Points& line, const PupilNormalisation& pupils, const FacialRegions& regions,
             std::vector<QPolygonF>& parts) {
  bool open = false;
  for (Eigen::Index i = 0; i < line.rows(); ++i) {
    const Eigen::Vector3d point = pupils.apply(line.row(i).transpose());
    const bool seen = point.z() > furthestBack && regions.outlineWeight(point.head<2>()) > 0.5;
    if (seen && !open) parts.emplace_back();
    if (seen) parts.back() << QPointF(point.x(), point.y());
    open = seen;
  }
}

ClosedCurves::Points closed(const ClosedCurves::Points& curve) {
  ClosedCurves::Points line(curve.rows() + 1, 3);
  line << curve, curve.row(0);
  return line;
}

}  // namespace

FaceLines genericFaceLines(const FacialRegions& regions) {
  vtkNew<vtkBoundaryCurveReader> reader;
  reader->Update();
  FaceCurves face;
  PupilNormalisation pupils;
  std::string fault = readFaceCurves(reader->GetOutput(), face);
  if (fault.empty()) fault = pupils.set(face.leftPupil, face.rightPupil);
  if (!fault.empty()) throw FileFailure("generic face: " + fault);
  FaceLines lines;
  for (int curve = 0; curve < face.curves.count; ++curve)
    addSeen(closed(face.curves.curve(curve)), pupils, regions, lines.curves);
  for (const ClosedCurves::Points& line : landmarkLines(face)) addSeen(line, pupils, regions, lines.features);
  return lines;
}

}  // namespace mien
