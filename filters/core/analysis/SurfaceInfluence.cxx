#include "SurfaceInfluence.h"

#include <cmath>
#include <limits>

#include "PDESurface.h"

namespace mien {

namespace {

constexpr double intervals = 27.0;

ClosedCurves unitMove(int pointsPerCurve, const InfluenceSource& source) {
  ClosedCurves move(FaceLayout::curveCount, pointsPerCurve);
  move.points.setZero();
  if (source.point == InfluenceSource::wholeCurve)
    move.curve(source.curve).col(0).setOnes();
  else
    move.curve(source.curve)(source.point, 0) = 1.0;
  return move;
}

double positionOf(int curve) {
  return curve > FaceLayout::upperLip ? curve - 1 : curve;
}

/// The row on a curve or nearest to it; the lips are two rows at one place.
int rowOf(const RowLayout& layout, const std::vector<double>& position, int curve) {
  if (curve == FaceLayout::upperLip) return layout.upperLipRow();
  if (curve == FaceLayout::lowerLip) return layout.upperLipRow() + 1;
  int nearest = 0;
  for (size_t row = 0; row < position.size(); ++row)
    if (std::abs(position[row] - positionOf(curve)) < std::abs(position[nearest] - positionOf(curve)))
      nearest = static_cast<int>(row);
  return nearest;
}

/// Rows from a start in steps of -1 or +1 to where the profile has fallen to half; NaN where it does not.
double rowsToHalf(const std::vector<double>& largest, int start, int step) {
  const double half = 0.5 * largest[start];
  for (int row = start + step; row >= 0 && row < static_cast<int>(largest.size()); row += step) {
    if (largest[row] > half) continue;
    const double before = largest[row - step];
    return std::abs(row - step - start) + (before - half) / (before - largest[row]);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// The same length counted in curves.
double curvesToHalf(const std::vector<double>& position, int start, int step, double rows) {
  if (std::isnan(rows)) return rows;
  const int last = start + step * static_cast<int>(rows);
  const int next = std::min(std::max(last + step, 0), static_cast<int>(position.size()) - 1);
  const double end = position[last] + (rows - std::floor(rows)) * (position[next] - position[last]);
  return std::abs(end - position[start]);
}

}  // namespace

RowMajor<double> surfaceInfluence(const FaceSurfaceOptions& options, int pointsPerCurve, const RowLayout& layout,
                                  int columns, const InfluenceSource& source) {
  const Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(columns + 1, 0.0, 2.0 * M_PI).head(columns);
  const HarmonicSplit split(pointsPerCurve, options.modes, options.remainder);
  PDESurface<double> surface(facePieces(options, layout), split, FaceLayout::curveCount, v, 0);
  if (!surface.fault().empty()) return {};
  surface.setCurves(unitMove(pointsPerCurve, source));
  RowMajor<double> vectors(layout.rows().size(), 3 * columns);
  surface.evaluate(0, 0, 0, PDESurface<double>::Grid(vectors.data(), vectors.rows(), vectors.cols()));
  RowMajor<double> influence(vectors.rows(), columns);
  for (int column = 0; column < columns; ++column) influence.col(column) = vectors.col(3 * column);
  return influence;
}

InfluenceProfile::InfluenceProfile(const RowMajor<double>& influence, const RowLayout& layout, int curve) {
  for (Eigen::Index row = 0; row < influence.rows(); ++row) {
    position.push_back(intervals * layout.rows()[row].faceU);
    largest.push_back(influence.row(row).cwiseAbs().maxCoeff());
  }
  const int start = rowOf(layout, position, curve);
  rowsAbove = rowsToHalf(largest, start, -1);
  rowsBelow = rowsToHalf(largest, start, 1);
  curvesAbove = curvesToHalf(position, start, -1, rowsAbove);
  curvesBelow = curvesToHalf(position, start, 1, rowsBelow);
}

}  // namespace mien
