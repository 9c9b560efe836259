#include "CurveCoder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "CurveTransform.h"
#include "DownwardOrder.h"
#include "FaceLayout.h"

namespace mien {

namespace {

constexpr int chainLength = FaceLayout::curveCount - 1;
constexpr int parting = chainLength;  ///< the row of the lips' half difference
constexpr double deadZone = 0.57;

/// x of a symmetric face is odd in v: sines; y and z are even.
bool isAsymmetric(int column, int axis) {
  const bool sine = column != 0 && column % 2 == 0;
  return sine != (axis == 0);
}

/// Low frequencies both along and around matter most.
int weightOf(int row, int column) {
  return (1 + (row == parting ? 0 : row)) * (1 + (column + 1) / 2);
}

using Coordinates = std::array<Eigen::MatrixXd, 3>;  ///< x, y, z: 29 x K, the chain and then the parting

Coordinates splitLips(const ClosedCurves& curves) {
  Coordinates split;
  for (int axis = 0; axis < 3; ++axis) {
    split[axis].resize(FaceLayout::curveCount, curves.pointsPerCurve);
    for (int c = 0; c < FaceLayout::curveCount; ++c)
      if (c != FaceLayout::lowerLip)
        split[axis].row(c > FaceLayout::lowerLip ? c - 1 : c) = curves.curve(c).col(axis).transpose();
    const auto upper = curves.curve(FaceLayout::upperLip).col(axis),
               lower = curves.curve(FaceLayout::lowerLip).col(axis);
    split[axis].row(FaceLayout::upperLip) = 0.5 * (upper + lower).transpose();
    split[axis].row(parting) = 0.5 * (upper - lower).transpose();
  }
  return split;
}

ClosedCurves joinLips(const Coordinates& split) {
  ClosedCurves curves(FaceLayout::curveCount, static_cast<int>(split[0].cols()));
  for (int axis = 0; axis < 3; ++axis) {
    for (int c = 0; c < FaceLayout::curveCount; ++c)
      curves.curve(c).col(axis) = split[axis].row(c >= FaceLayout::lowerLip ? c - 1 : c).transpose();
    curves.curve(FaceLayout::upperLip).col(axis) += split[axis].row(parting).transpose();
    curves.curve(FaceLayout::lowerLip).col(axis) -= split[axis].row(parting).transpose();
  }
  return curves;
}

/// The parting is a stack of one curve.
Eigen::MatrixXd transformed(const Eigen::MatrixXd& rows, bool forward) {
  const int k = static_cast<int>(rows.cols());
  const CurveTransform chain(chainLength, k), single(1, k);
  Eigen::MatrixXd result(rows.rows(), k);
  const Eigen::MatrixXd top = rows.topRows(chainLength), bottom = rows.bottomRows(1);
  result.topRows(chainLength) = forward ? chain.forward(top) : chain.inverse(top);
  result.bottomRows(1) = forward ? single.forward(bottom) : single.inverse(bottom);
  return result;
}

/// Takes away the rounding of the transform: point j and K - j mirror each other.
void mirrorExactly(ClosedCurves& curves) {
  const int k = curves.pointsPerCurve;
  for (int c = 0; c < curves.count; ++c) {
    auto curve = curves.curve(c);
    for (int j = 0; j <= k / 2; ++j) {
      const int other = (k - j) % k;
      const double x = other == j ? 0.0 : 0.5 * (curve(j, 0) - curve(other, 0));
      const double y = 0.5 * (curve(j, 1) + curve(other, 1)), z = 0.5 * (curve(j, 2) + curve(other, 2));
      curve.row(j) << x, y, z;
      curve.row(other) << (other == j ? 0.0 : -x), y, z;
    }
  }
}

std::int64_t levelOf(double coefficient, double step) {
  const double steps = std::abs(coefficient) / step;
  const auto level = static_cast<std::int64_t>(std::floor(steps + 1.0 - deadZone));
  return coefficient < 0.0 ? -level : level;
}

}  // namespace

CurveCoder::CurveCoder(int pointsPerCurve) : pointsPerCurve_(pointsPerCurve) {
  for (int row = 0; row < FaceLayout::curveCount; ++row)
    for (int column = 0; column < pointsPerCurve; ++column)
      for (int axis = 0; axis < 3; ++axis)
        places_.push_back({2 * isAsymmetric(column, axis) + (row == parting), row, column, axis});
  const auto key = [](const Place& p) {
    return std::make_tuple(p.part, weightOf(p.row, p.column), p.row, p.column, p.axis);
  };
  std::sort(places_.begin(), places_.end(), [&](const Place& a, const Place& b) { return key(a) < key(b); });
}

Eigen::VectorXd CurveCoder::coefficients(const ClosedCurves& curves) const {
  Coordinates coordinates = splitLips(curves);
  for (Eigen::MatrixXd& coordinate : coordinates) coordinate = transformed(coordinate, true);
  Eigen::VectorXd ordered(coefficientCount());
  for (size_t i = 0; i < places_.size(); ++i)
    ordered[i] = coordinates[places_[i].axis](places_[i].row, places_[i].column);
  return ordered;
}

CurveLevels CurveCoder::levels(const Eigen::VectorXd& coefficients, double step) const {
  CurveLevels levels{step, {}};
  for (const double coefficient : coefficients) levels.values.push_back(levelOf(coefficient, step));
  while (!levels.values.empty() && levels.values.back() == 0) levels.values.pop_back();
  return levels;
}

ClosedCurves CurveCoder::curves(const CurveLevels& levels) const {
  Coordinates coordinates;
  coordinates.fill(Eigen::MatrixXd::Zero(FaceLayout::curveCount, pointsPerCurve_));
  bool symmetric = true;
  for (size_t i = 0; i < levels.values.size(); ++i) {
    const Place& place = places_[i];
    coordinates[place.axis](place.row, place.column) = levels.step * static_cast<double>(levels.values[i]);
    symmetric = symmetric && (levels.values[i] == 0 || !isAsymmetric(place.column, place.axis));
  }
  for (Eigen::MatrixXd& coordinate : coordinates) coordinate = transformed(coordinate, false);
  ClosedCurves curves = joinLips(coordinates);
  if (symmetric) mirrorExactly(curves);
  restoreDownwardOrder(curves);
  return curves;
}

}  // namespace mien
