#include "BoxRatio.h"

namespace mien {

double boxRatio(const FaceSample& sample, const ClosedCurves& curves) {
  const Eigen::RowVector3d low = curves.points.colwise().minCoeff(), high = curves.points.colwise().maxCoeff();
  const Eigen::Array3d middle = 0.5 * (low + high).transpose().array();
  const Eigen::Array3d half = (0.5 * (high - low).transpose().array()).max(1e-9);
  double largest = 0.0;
  for (int row = 0; row < sample.rowCount(); ++row)
    for (int column = 0; column < sample.columnCount(); ++column)
      largest = std::max(largest, ((sample.point(row, column).array() - middle).abs() / half).maxCoeff());
  return largest;
}

}  // namespace mien
