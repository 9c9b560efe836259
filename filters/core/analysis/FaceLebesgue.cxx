#include "FaceLebesgue.h"

#include <algorithm>
#include <limits>
#include <set>

#include "ModeOperator.h"
#include "SharedDerivatives.h"

namespace mien {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Samples between two curves of a spline; a parabola through the best three gives the maximum to about 1e-6.
constexpr int samplesBetweenCurves = 48;
constexpr int intervalsPerPatch = FaceLayout::curvesPerPatch - 1;
constexpr double curveDistance = 1.0 / intervalsPerPatch;

/// Columns of values only, of every piece of the scheme at one rate.
double constantOfValues(const FaceScheme& scheme, double rate) {
  double largest = 0.0;
  for (const FaceScheme::Piece& piece : scheme.pieces) {
    const ModeOperator mode(rate, piece.conditions, piece.begin, piece.end);
    largest = std::max(largest, mode.solvable() ? mode.lebesgueConstant() : infinity);
  }
  return largest;
}

/// The rows of the piece of order 4 between two curves: (samples x (value, slope, value, slope)).
Eigen::MatrixXd rowsBetweenCurves(double rate) {
  const ModeOperator mode(rate, {{0.0, 0, 0}, {0.0, 1, 0}, {curveDistance, 0, 0}, {curveDistance, 1, 0}}, 0.0,
                          curveDistance);
  Eigen::MatrixXd rows(samplesBetweenCurves + 1, 4);
  for (int i = 0; i <= samplesBetweenCurves; ++i) rows.row(i) = mode.row(curveDistance * i / samplesBetweenCurves);
  return rows;
}

/// The top of the parabola through the largest sample and its neighbours.
double largestOfSamples(const Eigen::VectorXd& sums) {
  Eigen::Index best = 0;
  const double largest = sums.maxCoeff(&best);
  if (best == 0 || best + 1 == sums.size()) return largest;
  const double slope = 0.5 * (sums[best + 1] - sums[best - 1]);
  const double bend = sums[best + 1] - 2.0 * largest + sums[best - 1];
  return bend < 0.0 ? largest - 0.5 * slope * slope / bend : largest;
}

/// Of the spline between two neighbouring curves: values and slopes at both as combinations of the 29 curves.
double constantBetween(const Eigen::MatrixXd& rows, const Eigen::MatrixXd& slopes, int curve) {
  Eigen::MatrixXd data = Eigen::MatrixXd::Zero(4, FaceLayout::curveCount);
  for (int end = 0; end < 2; ++end) {
    data(2 * end, curve + end) = 1.0;
    data.row(2 * end + 1) = slopes.row(curve + end);
  }
  return largestOfSamples((rows * data).cwiseAbs().rowwise().sum());
}

double constantOfSpline(const FaceSurfaceOptions& options, int part) {
  auto rates = options.smoothing;
  for (double& rate : rates) rate *= part;
  const Eigen::MatrixXd slopes = options.derivativeStrength * sharedDerivatives(splineDerivatives, 1, rates);
  double largest = 0.0;
  Eigen::MatrixXd rows;
  for (int patch = 0; patch < FaceLayout::patchCount; ++patch) {
    if (patch == 0 || rates[patch] != rates[patch - 1]) rows = rowsBetweenCurves(rates[patch]);
    for (int i = 0; i < intervalsPerPatch; ++i)
      largest = std::max(largest, constantBetween(rows, slopes, FaceLayout::firstCurve[patch] + i));
  }
  return largest;
}

}  // namespace

double faceLebesgueConstant(const FaceSurfaceOptions& options, const HarmonicSplit& split) {
  const FaceScheme& scheme = *findFaceScheme(options.scheme);
  const std::set<double> smoothing(options.smoothing.begin(), options.smoothing.end());
  double largest = 0.0;
  for (int part = 0; part < split.count(); ++part) {
    if (scheme.derivatives == splineDerivatives)
      largest = std::max(largest, constantOfSpline(options, part));
    else
      for (const double a : smoothing) largest = std::max(largest, constantOfValues(scheme, split.rate(part, a)));
  }
  return largest;
}

}  // namespace mien
