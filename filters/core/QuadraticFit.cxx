#include "QuadraticFit.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

using Design = Eigen::Matrix<double, Eigen::Dynamic, 6>;

// Below this ratio of pivots, noise of the markers' precision decides a coefficient.
constexpr double rankThreshold = 1e-3;
constexpr double ridgeStrength = 0.1;

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
  change << s * s, 0, 0, -2 * s * s * x, 0, s * s * x * x,
      0, s * s, 0, -s * s * y, -s * s * x, s * s * x * y,
      0, 0, s * s, 0, -2 * s * s * y, s * s * y * y,
      0, 0, 0, s, 0, -s * x,
      0, 0, 0, 0, s, -s * y,
      0, 0, 0, 0, 0, 1;
  return framed.transpose() * change;
}

Eigen::Matrix<double, 6, 2> ridgeFit(const Design& design, const PlanePoints& displacement) {
  Eigen::Matrix<double, 6, 2> affine = Eigen::Matrix<double, 6, 2>::Zero();
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> plane(design.rightCols<3>());
  plane.setThreshold(rankThreshold);
  affine.bottomRows<3>() = plane.solve(displacement);
  const Eigen::Index count = design.rows();
  Eigen::MatrixXd augmented(count + 6, 6), target = Eigen::MatrixXd::Zero(count + 6, 2);
  augmented << design, ridgeStrength * std::sqrt(double(count)) * Eigen::MatrixXd::Identity(6, 6);
  target.topRows(count) = displacement - design * affine;
  return affine + augmented.colPivHouseholderQr().solve(target);
}

}  // namespace

QuadraticFit fitQuadraticMap(const PlanePoints& before, const PlanePoints& after) {
  const Frame frame(before);
  const Design design = designMatrix(before, frame);
  const PlanePoints displacement = after - before;
  Eigen::ColPivHouseholderQR<Design> decomposition(design);
  decomposition.setThreshold(rankThreshold);
  QuadraticFit fit;
  fit.points = static_cast<int>(before.rows());
  fit.rank = static_cast<int>(decomposition.rank());
  const Eigen::Matrix<double, 6, 2> framed =
      fit.sparse() ? ridgeFit(design, displacement) : Eigen::Matrix<double, 6, 2>(decomposition.solve(displacement));
  fit.map.coefficients = QuadraticMap::identity() + unframed(framed, frame);
  fit.rms = std::sqrt((displacement - design * framed).squaredNorm() / fit.points);
  fit.largestDisplacement = displacement.rowwise().norm().maxCoeff();
  return fit;
}

}  // namespace mien
