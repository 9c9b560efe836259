#include "CurveCrossings.h"

#include <cmath>

#include "Counted.h"
#include "FaceLayout.h"

namespace mien {

std::vector<int> crossingsBelow(const ClosedCurves& curves) {
  constexpr int placesPerSample = 8;
  constexpr double allowed = 0.1;  // mm, what contact may leave between samples
  std::vector<int> crossings(static_cast<std::size_t>(curves.count));
  for (int i = 0; i < placesPerSample * curves.pointsPerCurve; ++i) {
    const Eigen::VectorXd weights =
        cardinalWeights(curves.pointsPerCurve, 2.0 * M_PI * i / (placesPerSample * curves.pointsPerCurve));
    for (int c = 0; c + 1 < curves.count; ++c)
      crossings[c] += weights.dot(curves.curve(c).col(1)) < weights.dot(curves.curve(c + 1).col(1)) - allowed;
  }
  return crossings;
}

std::string namedCrossings(const ClosedCurves& curves) {
  const std::vector<int> crossings = crossingsBelow(curves);
  std::string names;
  for (int c = 0; c < curves.count; ++c)
    if (crossings[c] > 0)
      names += (names.empty() ? "" : ", ") + FaceLayout::curveName(c) + " and " + FaceLayout::curveName(c + 1) + " (" +
               counted(static_cast<std::size_t>(crossings[c]), "place") + ")";
  return names;
}

}  // namespace mien
