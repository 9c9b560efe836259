#include "OutermostPoints.h"

#include <limits>

#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace mien {

namespace {

// Half the camera's angle of 14 degrees has the tangent 0.12, wide pictures about twice that across.
constexpr double tangents[] = {0.0, 0.03, 0.06, 0.09, 0.12, 0.18, 0.24};
constexpr double none = -std::numeric_limits<double>::infinity();

}  // namespace

OutermostPoints::OutermostPoints(const ViewDirection& view) {
  std::array<double, 3> right, up, out;
  view.axes(right.data(), up.data(), out.data());
  for (const auto& side : {right, up})
    for (const double sign : {1.0, -1.0})
      for (const double tangent : tangents) {
        Extreme extreme{{}, none, {}};
        for (int i = 0; i < 3; ++i) extreme.direction[i] = sign * side[i] + tangent * out[i];
        extremes_.push_back(extreme);
      }
}

void OutermostPoints::add(vtkPoints* points) {
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i) {
    std::array<double, 3> p;
    points->GetPoint(i, p.data());
    for (Extreme& extreme : extremes_) {
      const auto& d = extreme.direction;
      const double distance = p[0] * d[0] + p[1] * d[1] + p[2] * d[2];
      if (distance <= extreme.distance) continue;
      extreme.distance = distance;
      extreme.point = p;
    }
  }
}

vtkSmartPointer<vtkPolyData> OutermostPoints::points() const {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Extreme& extreme : extremes_)
    if (extreme.distance > none) points->InsertNextPoint(extreme.point.data());
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  return data;
}

}  // namespace mien
