#include "FaceScheme.h"

#include <algorithm>

namespace mien {

namespace {

constexpr double third = 1.0 / 3.0;
constexpr double twoThirds = 2.0 / 3.0;

/// Interior curves make the Lebesgue constant grow like e^(a (N + 1) / 3); 250 gives 1e36.
constexpr double largestRateThroughCurves = 250.0;
/// Schemes that hold the ends only stay bounded; a up to 1000 with N up to 128 lies below this.
constexpr double largestRateBetweenEnds = 1000.0 * 129.0;

}  // namespace

const std::vector<FaceScheme>& faceSchemes() {
  static const std::vector<FaceScheme> schemes = {
      {"four-curve",
       "through all four curves of a patch, as in the paper; seams are C0",
       {{0, 1, {{0, 0, 0}, {third, 0, 1}, {twoThirds, 0, 2}, {1, 0, 3}}}},
       differenceDerivatives,
       largestRateThroughCurves},
      {"derivative",
       "through the outer two curves with the shared slope at both; seams are C1",
       {{0, 1, {{0, 0, 0}, {0, 1, 0}, {1, 0, 3}, {1, 1, 3}}}},
       differenceDerivatives,
       largestRateBetweenEnds},
      {"sixth-order",
       "through the outer two curves with shared slope and second derivative; seams are C2",
       {{0, 1, {{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {1, 0, 3}, {1, 1, 3}, {1, 2, 3}}}},
       differenceDerivatives,
       largestRateBetweenEnds},
      {"tangent",
       "through all four curves with the shared slope at the outer two; seams are C1",
       {{0, 1, {{0, 0, 0}, {0, 1, 0}, {third, 0, 1}, {twoThirds, 0, 2}, {1, 0, 3}, {1, 1, 3}}}},
       differenceDerivatives,
       largestRateThroughCurves},
      {"curvature",
       "through all four curves with shared slope and second derivative at the outer two; seams are C2",
       {{0, 1, {{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {third, 0, 1}, {twoThirds, 0, 2}, {1, 0, 3}, {1, 1, 3}, {1, 2, 3}}}},
       differenceDerivatives,
       largestRateThroughCurves},
      {"spline",
       "one piece per pair of neighbouring curves, with slopes that make S_uu continuous everywhere; C2",
       {{0, third, {{0, 0, 0}, {0, 1, 0}, {third, 0, 1}, {third, 1, 1}}},
        {third, twoThirds, {{third, 0, 1}, {third, 1, 1}, {twoThirds, 0, 2}, {twoThirds, 1, 2}}},
        {twoThirds, 1, {{twoThirds, 0, 2}, {twoThirds, 1, 2}, {1, 0, 3}, {1, 1, 3}}}},
       splineDerivatives,
       largestRateBetweenEnds},
  };
  return schemes;
}

const FaceScheme* findFaceScheme(const std::string& name) {
  const auto& schemes = faceSchemes();
  const auto found = std::find_if(schemes.begin(), schemes.end(), [&](const auto& s) { return s.name == name; });
  return found == schemes.end() ? nullptr : &*found;
}

}  // namespace mien
