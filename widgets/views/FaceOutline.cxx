#include "FaceOutline.h"

#include <vtkBoundaryCurveReader.h>
#include <vtkMath.h>
#include <vtkPolyData.h>

#include <cmath>
#include <functional>

#include "FaceModel.h"
#include "MotionReach.h"

namespace mien {

namespace {

constexpr double viewMargin = 0.075;  // of the face's width, beside it at rest; its near parts look larger
constexpr double jawRoom = 0.13;      // below it, of its height: for the chin of every expression; as much above it
constexpr double thinMargin = 0.03;   // around all that it reaches
constexpr double nearestShare = 0.5;  // of the distance: what comes nearer is not magnified further
constexpr double mostReach = 0.6;     // values beyond all sense must not make a face a dot

/// Where it is seen in the plane through the middle of the outline: what is nearer looks larger.
void addSeen(const ViewAxes& axes, const double point[3], const FaceOutline& middle, double distance,
             FaceOutline& outline) {
  const double nearer = vtkMath::Dot(axes.out, point) - middle.middle(2);
  const double scale = distance / std::max(nearestShare * distance, distance - nearer);
  const double* directions[] = {axes.right, axes.up};
  for (int axis : {0, 1}) {
    const double centre = middle.middle(axis);
    outline.add(axis, centre + scale * (vtkMath::Dot(directions[axis], point) - centre));
  }
}

using Choice = std::function<bool(const double*)>;

SeenPoints furthestOf(vtkPolyData* mesh, const Choice& counts) {
  const ViewAxes views[] = {ViewAxes(0.0), ViewAxes(45.0), ViewAxes(90.0)};
  std::vector<const double*> directions = {views[0].up};
  for (const ViewAxes& view : views) directions.push_back(view.right);
  SeenPoints points(2 * directions.size());
  std::vector<double> reach(points.size(), -1e300);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i) {
    std::array<double, 3> point;
    mesh->GetPoint(i, point.data());
    if (!counts(point.data())) continue;
    for (size_t d = 0; d < points.size(); ++d) {
      const double along = (d % 2 == 0 ? 1.0 : -1.0) * vtkMath::Dot(directions[d / 2], point.data());
      if (along <= reach[d]) continue;
      reach[d] = along;
      points[d] = point;
    }
  }
  return reach[0] > -1e300 ? points : SeenPoints();
}

}  // namespace

ViewAxes::ViewAxes(double degrees) {
  const double turn = degrees * M_PI / 180.0;
  right[0] = out[2] = std::cos(turn);
  right[1] = out[1] = 0.0;
  out[0] = std::sin(turn);
  right[2] = -out[0];
}

void FaceOutline::add(const ViewAxes& axes, const double point[3], double room) {
  for (const double aside : {-room, room}) {
    add(0, vtkMath::Dot(axes.right, point) + aside);
    add(1, vtkMath::Dot(axes.up, point) + aside);
  }
  add(2, vtkMath::Dot(axes.out, point));
}

SeenPoints cornersAround(const double* bounds) {
  SeenPoints corners(8);
  for (int corner = 0; corner < 8; ++corner)
    for (int i = 0; i < 3; ++i) {
      const double room = thinMargin * (bounds[2 * i + 1] - bounds[2 * i]);
      corners[corner][i] = corner >> i & 1 ? bounds[2 * i + 1] + room : bounds[2 * i] - room;
    }
  return corners;
}

SeenPoints furthestPoints(vtkPolyData* mesh) {
  return furthestOf(mesh, [](const double*) { return true; });
}

SeenPoints furthestOfHead(vtkPolyData* mesh, const FaceModel& model) {
  const FaceOutline face = restingOutline(ViewAxes(0.0), model);
  return furthestOf(mesh, [&](const double* point) {
    const double aside = std::abs(point[0] - face.middle(0)) - 0.5 * face.size(0);
    return point[1] >= face.low[1] && point[1] <= face.high[1] + mostReach * face.size(1) &&
           aside <= mostReach * face.size(0);
  });
}

FaceOutline restingOutline(const ViewAxes& axes, const FaceModel& model) {
  FaceOutline rest;
  vtkPolyData* curves = model.pipeline().neutralCurves()->GetOutput();
  for (vtkIdType i = 0; i < curves->GetNumberOfPoints(); ++i) rest.add(axes, curves->GetPoint(i));
  return rest;
}

FaceOutline outlineOf(const ViewAxes& axes, const FaceModel& model, const FaceOutline& seen, double distance) {
  FaceOutline rest = restingOutline(axes, model), reach;
  for (const MotionReach::Point& point : model.reach().points()) addSeen(axes, point.data(), seen, distance, reach);
  for (int axis : {0, 1}) {
    const double size = rest.size(axis), room = (axis == 1 ? jawRoom : viewMargin) * size, most = mostReach * size;
    const double below = rest.low[axis] - reach.low[axis] + thinMargin * size;
    const double beyond = reach.high[axis] - rest.high[axis] + thinMargin * size;
    rest.low[axis] -= std::clamp(below, room, most);
    rest.high[axis] += std::clamp(beyond, room, most);
  }
  return rest;
}

}  // namespace mien
