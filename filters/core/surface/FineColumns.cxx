#include "FineColumns.h"

#include <cmath>

#include "ClosedCurves.h"

namespace mien {

Eigen::MatrixXd fineColumns(int pointsPerCurve) {
  const int n = columnsPerSample * pointsPerCurve;
  Eigen::MatrixXd columns(n, pointsPerCurve);
  for (int i = 0; i < n; ++i) columns.row(i) = cardinalWeights(pointsPerCurve, 2.0 * M_PI * i / n);
  return columns;
}

}  // namespace mien
