#include "CurveModes.h"

#include <algorithm>

#include "DownwardOrder.h"
#include "FaceLayout.h"
#include "HarmonicSplit.h"

namespace mien {

ClosedCurves firstModes(const ClosedCurves& curves, int modes) {
  const int k = curves.pointsPerCurve;
  const HarmonicSplit split(k, modes, false);
  const int kept = std::min(2 * modes + 1, k);
  const Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(k + 1, 0.0, 2.0 * M_PI).head(k);
  const Eigen::MatrixXd projection = split.synthesis(v, 0).leftCols(kept) * split.analysis().topRows(kept);
  ClosedCurves result = curves;
  for (int c = 0; c < curves.count; ++c) result.curve(c) = projection * curves.curve(c);
  restoreDownwardOrder(result);
  return result;
}

int modeNumberCount(int pointsPerCurve, int modes) {
  return FaceLayout::curveCount * std::min(2 * modes + 1, pointsPerCurve) * 3;
}

}  // namespace mien
