#include "FaceArrows.h"

#include <cmath>
#include <map>

#include "FaceFrame.h"
#include "FaceLines.h"
#include "FaceOptions.h"
#include "FacePipeline.h"
#include "Failure.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkStructuredGrid.h"

namespace mien {

namespace {

constexpr int rows = 164, columns = 160;  // points every 0.1 pupil units in front, an arrow's place to half of that

/// The point of the face that is nearest to each place of a lattice around the middle of the pupils.
class Lattice {
 public:
  explicit Lattice(double spacing) : spacing_(spacing) {}

  void offer(const Eigen::Vector2d& point, vtkIdType id) {
    const Eigen::Vector2d cell = (point / spacing_).array().round();
    const double distance = (point - spacing_ * cell).norm();
    if (distance > 0.25 * spacing_) return;
    const auto key = std::pair(static_cast<int>(cell.x()), static_cast<int>(cell.y()));
    const auto found = nearest_.find(key);
    if (found == nearest_.end() || distance < found->second.first) nearest_[key] = {distance, id};
  }

  const std::map<std::pair<int, int>, std::pair<double, vtkIdType>>& nearest() const { return nearest_; }

 private:
  double spacing_;
  std::map<std::pair<int, int>, std::pair<double, vtkIdType>> nearest_;
};

FaceFrame genericFrameOf(vtkStructuredGrid* grid, const FacialRegions& regions) {
  FaceFrame frame;
  const std::string fault = readFaceFrame(grid, {}, regions, frame);
  if (!fault.empty()) throw FileFailure("generic face: " + fault);
  return frame;
}

}  // namespace

FaceArrows genericFaceArrows(const DeformationTable& table, const DeformationOptions& options, double spacing) {
  FacePipeline pipeline;
  FaceOptions face;
  face.setDefaultResolution(rows, columns);
  face.apply(pipeline);
  updateOrThrow(pipeline);
  const FacialRegions regions = options.reading.regions();
  const FaceFrame frame = genericFrameOf(pipeline.grid(), regions);
  DeformationOptions own = options;
  own.reading = own.reading.regionsOnly();
  const auto moved = deformSurface(pipeline.grid(), table, own, "generic face");
  vtkDataArray* moves = moved->GetPointData()->GetArray("Displacement");
  Lattice lattice(spacing);
  for (std::size_t i = 0; i < frame.points.size(); ++i) {
    const Eigen::Vector3d place = frame.pupils.apply(frame.points[i].position);
    const bool seen = place.z() > furthestBack;
    if (seen && regions.outlineWeight(place.head<2>()) > 0.5) lattice.offer(place.head<2>(), static_cast<vtkIdType>(i));
  }
  FaceArrows result;
  result.pupilUnit = frame.pupils.unit();
  for (const auto& [cell, point] : lattice.nearest()) {
    Eigen::Vector3d move;
    moves->GetTuple(point.second, move.data());
    const Eigen::Vector3d at = frame.points[point.second].position, from = frame.pupils.apply(at),
                          to = frame.pupils.apply(at + move);
    result.arrows.push_back({{from.x(), from.y()}, {to.x() - from.x(), to.y() - from.y()}});
  }
  return result;
}

}  // namespace mien
