#include "MovedCurveOrder.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "CurveOrder.h"
#include "DownwardOrder.h"
#include "FaceCurves.h"
#include "FaceLayout.h"

namespace mien {

namespace {

constexpr int upperLid = 8;  // index of C9; the lower lid is the next
constexpr int halvings = 12;

void meetHalfway(ClosedCurves& curves, int upper) {
  for (int j = 0; j < curves.pointsPerCurve; ++j) {
    double &above = curves.points(upper * curves.pointsPerCurve + j, 1),
           &below = curves.points((upper + 1) * curves.pointsPerCurve + j, 1);
    if (above < below) above = below = 0.5 * (above + below);
  }
}

ClosedCurves between(const ClosedCurves& neutral, const ClosedCurves& moved, double share) {
  ClosedCurves result = neutral;
  result.points += share * (moved.points - neutral.points);
  return result;
}

/// The largest share of the movement, to 1 / 4096, that crosses nothing.
double largestShare(const ClosedCurves& neutral, const ClosedCurves& moved) {
  double low = 0.0, high = 1.0;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (countCrossings(between(neutral, moved, middle)) ? high : low) = middle;
  }
  return low;
}

}  // namespace

MovedCurveOrder::MovedCurveOrder(const ClosedCurves& neutral, ClosedCurves& moved) {
  if (countCrossings(moved) == 0 || countCrossings(neutral) > 0) return;
  const ClosedCurves given = moved;
  std::vector<ContactPair> contacts(2);
  for (const auto& [i, upper] : {std::pair(0, upperLid), std::pair(1, int(FaceLayout::upperLip))}) {
    contacts[i].upper = upper;
    contacts[i].lower = upper + 1;
    meetHalfway(moved, upper);
  }
  CurveOrder(neutral, contacts).restore(moved);
  restoreDownwardOrder(moved);
  if (countCrossings(moved) > 0) {
    keptShare = largestShare(neutral, moved);
    moved = between(neutral, moved, keptShare);
  }
  pushed = (moved.points - between(neutral, given, keptShare).points).col(1).cwiseAbs().maxCoeff();
}

}  // namespace mien
