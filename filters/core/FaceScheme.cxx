#include "FaceScheme.h"

#include <algorithm>

namespace mien {

namespace {

constexpr double third = 1.0 / 3.0;

/// Interior curves make the Lebesgue constant grow like e^(a (N + 1) / 3); 250 gives 1e36.
constexpr double largestRateThroughCurves = 250.0;
/// Schemes that hold the ends only stay bounded; a up to 1000 with N up to 128 lies below this.
constexpr double largestRateBetweenEnds = 1000.0 * 129.0;

}  // namespace

const std::vector<FaceScheme>& faceSchemes() {
  static const std::vector<FaceScheme> schemes = {
      {"four-curve",
       "through all four curves of a patch, as in the paper",
       {{0.0, 1.0, {{0.0, 0, 0}, {third, 0, 1}, {2.0 * third, 0, 2}, {1.0, 0, 3}}}},
       largestRateThroughCurves},
      {"derivative",
       "through the outer two curves, with the shared slope at both",
       {{0.0, 1.0, {{0.0, 0, 0}, {0.0, 1, 0}, {1.0, 0, 3}, {1.0, 1, 3}}}},
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
