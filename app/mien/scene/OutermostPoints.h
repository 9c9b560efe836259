#pragma once

#include <array>
#include <vector>

#include "ViewDirection.h"
#include "vtkSmartPointer.h"

class vtkPoints;
class vtkPolyData;

namespace mien {

/// The outermost of any number of points as a weak perspective sees them, in little memory: enough to frame them all.
///
/// A point p is seen at tangent t = p.r / (d - p.o), and lies within t when p.(r + t o) <= t d: the outermost points
/// to each side of the picture are those farthest along r + t o, for the few t that a face's frame can have.
class OutermostPoints {
 public:
  explicit OutermostPoints(const ViewDirection& view);

  void add(vtkPoints* points);

  /// At most one point for each direction; none when none were added.
  vtkSmartPointer<vtkPolyData> points() const;

 private:
  struct Extreme {
    std::array<double, 3> direction;
    double distance;
    std::array<double, 3> point;
  };

  std::vector<Extreme> extremes_;
};

}  // namespace mien
