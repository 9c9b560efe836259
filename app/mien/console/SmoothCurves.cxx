#include "SmoothCurves.h"

#include <cmath>

#include "BoundaryCurveData.h"
#include "vtkPolyData.h"

namespace mien {

namespace {

constexpr int pointsPerSample = 8;

}  // namespace

vtkSmartPointer<vtkPolyData> smoothCurves(vtkPolyData* data) {
  auto smooth = vtkSmartPointer<vtkPolyData>::New();
  ClosedCurves curves;
  if (!readClosedCurves(data, curves).empty()) return smooth;
  ClosedCurves fine(curves.count, pointsPerSample * curves.pointsPerCurve);
  for (int j = 0; j < fine.pointsPerCurve; ++j) {
    const Eigen::RowVectorXd weights = cardinalWeights(curves.pointsPerCurve, 2.0 * M_PI * j / fine.pointsPerCurve);
    for (int index = 0; index < curves.count; ++index) fine.curve(index).row(j) = weights * curves.curve(index);
  }
  writeClosedCurves(fine, smooth);
  return smooth;
}

}  // namespace mien
