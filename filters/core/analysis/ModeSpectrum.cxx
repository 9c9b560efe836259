#include "ModeSpectrum.h"

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

/// Trapezoidal weights in the u of the whole face; the two lip rows have no interval between them.
Eigen::VectorXd trapezoidalWeights(const std::vector<FaceRow>& rows) {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(rows.size());
  for (size_t i = 1; i < rows.size(); ++i) {
    const double half = 0.5 * (rows[i].faceU - rows[i - 1].faceU);
    weights[i - 1] += half;
    weights[i] += half;
  }
  return weights / weights.sum();
}

/// Of points stored side by side in rows.
double largestLength(const RowMajor<double>& grid) {
  double largest = 0.0;
  for (Eigen::Index row = 0; row < grid.rows(); ++row)
    for (Eigen::Index i = 0; i < grid.cols(); i += 3) largest = std::max(largest, grid.block<1, 3>(row, i).norm());
  return largest;
}

}  // namespace

ModeSpectrum::ModeSpectrum(const FaceSurfaceOptions& options, const RowLayout& layout, int pointsPerCurve,
                           const Eigen::VectorXd& v)
    : split_(pointsPerCurve, options.modes, options.remainder),
      rowWeights_(trapezoidalWeights(layout.rows())),
      u_(split_.count(), Eigen::MatrixXd::Zero(layout.rows().size(), FaceLayout::curveCount)),
      synthesis_(split_.synthesis(v, 0)),
      columnCount_(v.size()),
      analysis_(split_.analysis()) {
  for (const SurfacePiece& piece : facePieces(options, layout)) {
    if (piece.u.empty()) continue;
    const Eigen::MatrixXd u = surfaceOperator(piece, split_, FaceLayout::curveCount, 0);
    if (u.size() == 0) {
      fault_ = "the conditions of scheme " + options.scheme + " do not determine a surface; choose another";
      return;
    }
    for (int part = 0; part < partCount(); ++part)
      for (int c = 0; c < FaceLayout::curveCount; ++c)
        u_[part].col(c).segment(piece.firstRow, u.rows()) = u.col(c * partCount() + part);
  }
}

void ModeSpectrum::setCurves(const ClosedCurves& curves) {
  fourierCoefficients(analysis_, curves, samples_, coefficients_);
}

std::string ModeSpectrum::name(int part) const {
  return part > split_.modes() ? "remainder" : std::to_string(part);
}

Eigen::MatrixXd ModeSpectrum::curvesOfPart(int part) const {
  const int first = split_.firstCoefficient(part), count = split_.coefficientCount(part);
  const Eigen::MatrixXd sampled = synthesis_.middleCols(first, count) * coefficients_.middleRows(first, count);
  Eigen::MatrixXd curves(FaceLayout::curveCount, 3 * columnCount_);
  for (int c = 0; c < FaceLayout::curveCount; ++c)
    for (Eigen::Index i = 0; i < columnCount_; ++i) curves.block<1, 3>(c, 3 * i) = sampled.block<1, 3>(i, 3 * c);
  return curves;
}

RowMajor<double> ModeSpectrum::contribution(int part) const {
  return u_[part] * curvesOfPart(part);
}

// Mode 0 does not depend on v, so its coefficients are its values.
Eigen::RowVector3d ModeSpectrum::centroid() const {
  const Eigen::RowVectorXd ofCurves = rowWeights_.transpose() * u_[0];
  Eigen::RowVector3d centre;
  for (int xyz = 0; xyz < 3; ++xyz) {
    double sum = 0.0;
    for (int c = 0; c < FaceLayout::curveCount; ++c) sum += ofCurves[c] * coefficients_(0, 3 * c + xyz);
    centre[xyz] = sum;
  }
  return centre;
}

// Parseval: the mean over v of (a cos nv)^2 is a^2 / 2, of a constant its square.
double ModeSpectrum::meanSquare(int part) const {
  const int first = split_.firstCoefficient(part);
  const Eigen::RowVector3d centre = centroid();
  double sum = 0.0;
  for (int i = first; i < first + split_.coefficientCount(part); ++i)
    for (int xyz = 0; xyz < 3; ++xyz) {
      Eigen::VectorXd ofCurves(FaceLayout::curveCount);
      for (int c = 0; c < FaceLayout::curveCount; ++c) ofCurves[c] = coefficients_(i, 3 * c + xyz);
      const Eigen::ArrayXd ofRows = (u_[part] * ofCurves).array() - (part == 0 ? centre[xyz] : 0.0);
      sum += (part == 0 ? 1.0 : 0.5) * (rowWeights_.array() * ofRows.square()).sum();
    }
  return sum;
}

std::vector<ModeMeasures> ModeSpectrum::measures(const std::function<bool()>& goOn) const {
  std::vector<ModeMeasures> all(partCount());
  const Eigen::RowVector3d centre = centroid();
  double total = 0.0;
  for (int part = partCount() - 1; part >= 0; --part) {
    if (!goOn()) return {};
    const double energy = meanSquare(part);
    RowMajor<double> grid = contribution(part);
    for (Eigen::Index i = 0; part == 0 && i < columnCount_; ++i) grid.middleCols<3>(3 * i).rowwise() -= centre;
    all[part] = {name(part), std::sqrt(energy), largestLength(grid), energy, std::sqrt(total)};
    total += energy;
  }
  for (ModeMeasures& mode : all) mode.energyShare = total > 0.0 ? mode.energyShare / total : 0.0;
  return all;
}

int smallestModeCount(const std::vector<ModeMeasures>& measures, double tolerance) {
  for (size_t n = 0; n < measures.size(); ++n)
    if (measures[n].mode != "remainder" && measures[n].cumulativeError <= tolerance) return static_cast<int>(n);
  return -1;
}

}  // namespace mien
