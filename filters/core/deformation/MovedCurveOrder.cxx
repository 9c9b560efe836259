#include "MovedCurveOrder.h"

#include <algorithm>
#include <utility>

#include "CurveOrder.h"
#include "DownwardOrder.h"
#include "FaceCurves.h"
#include "FaceLayout.h"

namespace mien {

namespace {

constexpr int upperLid = 8;  // index of C9; the lower lid is the next

void meetHalfway(ClosedCurves& curves, int upper) {
  for (int j = 0; j < curves.pointsPerCurve; ++j) {
    double &above = curves.points(upper * curves.pointsPerCurve + j, 1),
           &below = curves.points((upper + 1) * curves.pointsPerCurve + j, 1);
    if (above < below) above = below = 0.5 * (above + below);
  }
}

bool isInOrder(const ClosedCurves& curves) {
  const Eigen::Index below = curves.points.rows() - curves.pointsPerCurve;
  return (curves.points.topRows(below).col(1) - curves.points.bottomRows(below).col(1)).minCoeff() >= 0.0;
}

}  // namespace

MovedCurveOrder::MovedCurveOrder(const ClosedCurves& neutral, ClosedCurves& moved) {
  if (isInOrder(moved)) return;
  const ClosedCurves::Points given = moved.points;
  std::vector<ContactPair> contacts(2);
  for (const auto& [i, upper] : {std::pair(0, upperLid), std::pair(1, int(FaceLayout::upperLip))}) {
    contacts[i].upper = upper;
    contacts[i].lower = upper + 1;
    meetHalfway(moved, upper);
  }
  CurveOrder order(neutral, contacts);
  order.restore(moved);
  restoreDownwardOrder(moved);  // what rounding, or a face that crossed before, left
  keptShare = order.keptShare();
  pushed = (moved.points - given).col(1).cwiseAbs().maxCoeff();
  crossings = countCrossings(moved);
}

}  // namespace mien
