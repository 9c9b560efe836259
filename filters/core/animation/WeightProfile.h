#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "FaceCurves.h"

namespace mien {

/// How a weight goes from one knot to the next, s running from 0 to 1.
enum class ProfileShape {
  Linear,    ///< s
  Sinusoid,  ///< sin^2(pi s / 2); two staggered ones sum to 1
  Parabola   ///< s^2 with the vertex at the knot nearer the middle of the face
};

/// A place along v, told by a feature point and an offset so that it holds on every face, and the weight there.
struct ProfileKnot {
  std::string feature;                          ///< MPEG-4 name, or several as "2.4|8.3": the first that the face has
  double offset = 0.0;                          ///< radians
  double weight = 0.0;                          ///< 0 .. 1
  ProfileShape shape = ProfileShape::Sinusoid;  ///< towards the next knot
};

/// A weight over v, the same on every curve it is used on.
///
/// Either knots with shapes between them, 0 outside; or, with `gapUpper` and `gapLower` >= 0, the gap
/// between two curves around a feature point in units of the gap there, as a lid needs that is to close
/// over the whole eye: between the corners `gapFrom` and `gapTo` and a little beyond, or, on a face without
/// these, as far as the gap narrows.
struct WeightProfile {
  std::vector<ProfileKnot> knots;
  int gapUpper = -1;
  int gapLower = -1;
  std::string gapFrom, gapTo;  ///< feature points, in ascending v

  bool followsGap() const { return gapUpper >= 0; }

  /// Where along v the curve is to have weight 1 exactly: the feature points on the curves moved whose knot has it.
  std::vector<double> exactPlaces(const FaceCurves& face, const std::vector<int>& curves) const;

  /// The weights at the K samples of the curves of this face; `feature` is the one the FAP moves.
  /// @return nothing, or one sentence that says what the face lacks
  std::string sample(const FaceCurves& face, const FeaturePoint& feature, Eigen::VectorXd& weights) const;
};

}  // namespace mien
