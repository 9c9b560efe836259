#include "QuadraticFit.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace mien {

namespace {

using Design = Eigen::Matrix<double, Eigen::Dynamic, 6>;

// Below this ratio of pivots, noise of the markers' precision decides a coefficient.
constexpr double rankThreshold = 1e-3;
constexpr double sparseRidge = 0.1;
constexpr double coefficientDeviation = 0.3;

/// Centre and half-extent that bring the points into about [-1, 1].
struct Frame {
  Eigen::RowVector2d centre;
  double scale = 1.0;

  explicit Frame(const PlanePoints& points) : centre(points.colwise().mean()) {
    scale = std::max((points.rowwise() - centre).rowwise().norm().maxCoeff(), 1e-12);
  }
};

Design designMatrix(const PlanePoints& points, const Frame& frame) {
  Design design(points.rows(), 6);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    design.row(i) = QuadraticMap::basis((points.row(i) - frame.centre).transpose() / frame.scale);
  return design;
}

/// Coefficients in the frame, as coefficients of x and y: substitutes X = (x - cx) / s, Y = (y - cy) / s.
QuadraticMap::Coefficients unframed(const Eigen::Matrix<double, 6, 2>& framed, const Frame& frame) {
  const double s = 1.0 / frame.scale, x = frame.centre.x(), y = frame.centre.y();
  Eigen::Matrix<double, 6, 6> change;
  change << s * s, 0, 0, -2 * s * s * x, 0, s * s * x * x, 0, s * s, 0, -s * s * y, -s * s * x, s * s * x * y, 0, 0,
      s * s, 0, -2 * s * s * y, s * s * y * y, 0, 0, 0, s, 0, -s * x, 0, 0, 0, 0, s, -s * y, 0, 0, 0, 0, 0, 1;
  return framed.transpose() * change;
}

using Solution = Eigen::Matrix<double, 6, 2>;

/// The last columns of the design alone (3: an affine map, 6: all), each but the last (the shift) with its own ridge.
Solution ridgeFit(const Design& design, const PlanePoints& displacement, int columns, double ridge) {
  const Eigen::Index count = design.rows();
  Eigen::MatrixXd augmented = Eigen::MatrixXd::Zero(count + columns, columns);
  Eigen::MatrixXd target = Eigen::MatrixXd::Zero(count + columns, 2);
  augmented.topRows(count) = design.rightCols(columns);
  augmented.bottomRows(columns).diagonal().head(columns - 1).setConstant(ridge);
  target.topRows(count) = displacement;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  decomposition.setThreshold(ridge > 0.0 ? 1e-15 : rankThreshold);
  decomposition.compute(augmented);
  Solution result = Solution::Zero();
  result.bottomRows(columns) = decomposition.solve(target);
  return result;
}

/// An affine fit, and what it leaves fitted with a ridge.
Solution sparseFit(const Design& design, const PlanePoints& displacement, double ridge) {
  const Solution affine = ridgeFit(design, displacement, 3, ridge);
  const double strength = std::max(sparseRidge * std::sqrt(double(design.rows())), ridge);
  return affine + ridgeFit(design, displacement - design * affine, 6, strength);
}

}  // namespace

QuadraticFit fitQuadraticMap(const PlanePoints& before, const PlanePoints& after, double noise) {
  const Frame frame(before);
  const Design design = designMatrix(before, frame);
  const PlanePoints displacement = after - before;
  Eigen::ColPivHouseholderQR<Design> decomposition;
  decomposition.setThreshold(rankThreshold);
  decomposition.compute(design);
  QuadraticFit fit;
  fit.points = static_cast<int>(before.rows());
  fit.rank = static_cast<int>(decomposition.rank());
  const double ridge = noise / coefficientDeviation;
  Solution framed;
  if (fit.sparse())
    framed = sparseFit(design, displacement, ridge);
  else if (fit.weak() && ridge > 0.0)
    framed = ridgeFit(design, displacement, 6, ridge);
  else
    framed = decomposition.solve(displacement);
  fit.map.coefficients = QuadraticMap::identity() + unframed(framed, frame);
  fit.rms = std::sqrt((displacement - design * framed).squaredNorm() / fit.points);
  fit.largestDisplacement = displacement.rowwise().norm().maxCoeff();
  return fit;
}

}  // namespace mien
