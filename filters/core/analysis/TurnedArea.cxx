#include "TurnedArea.h"

#include <Eigen/Geometry>

#include "FoldedCells.h"

namespace mien {

double turnedAreaShare(const FaceSample& sample, const FaceSample& reference) {
  const auto area = [&](int row, int column) {
    return reference.point(row, column).z() > FoldedCells::frontalZ ? reference.areaElement(row, column) : 0.0;
  };
  const double turned = integrate(reference, [&](int row, int column) {
    const bool opposed = sample.areaVector(row, column).dot(reference.areaVector(row, column)) < 0.0;
    return opposed ? area(row, column) : 0.0;
  });
  return turned / integrate(reference, area);
}

}  // namespace mien
