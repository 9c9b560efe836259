#include "FaceCurves.h"

#include <algorithm>
#include <numeric>

#include "CurveCrossings.h"
#include "FaceLayout.h"

namespace mien {

namespace {

/// Curves run down the face: below a point of one curve lies the same point of the next. The contact
/// of closed lips and lids leaves rounding, which is no crossing.
constexpr double crossingTolerance = 1e-6;

std::string describeCrossing(const ClosedCurves& curves) {
  for (int c = 0; c + 1 < curves.count; ++c)
    for (int j = 0; j < curves.pointsPerCurve; ++j)
      if (curves.curve(c)(j, 1) < curves.curve(c + 1)(j, 1) - crossingTolerance)
        return "curve " + FaceLayout::curveName(c) + " lies below " + FaceLayout::curveName(c + 1) + " at point " +
               std::to_string(j) + "; curves must run down the face without crossing";
  return {};
}

std::string describeFeatureFault(const FaceCurves& face) {
  for (const FeaturePoint& feature : face.features)
    if (feature.curve < 0 || feature.curve >= face.curves.count || !(feature.v >= 0.0 && feature.v < 6.2831854))
      return "feature point " + feature.id + " lies on no curve of the face";
  return {};
}

}  // namespace

const FeaturePoint* FaceCurves::feature(const std::string& id) const {
  const auto found = std::find_if(features.begin(), features.end(), [&](const auto& f) { return f.id == id; });
  return found == features.end() ? nullptr : &*found;
}

int countCrossings(const ClosedCurves& curves) {
  const std::vector<int> crossings = crossingsBelow(curves);
  return std::accumulate(crossings.begin(), crossings.end(), 0);
}

std::string describeFault(const FaceCurves& face) {
  if (face.curves.count != FaceLayout::curveCount)
    return "a face has " + std::to_string(FaceLayout::curveCount) + " boundary curves, not " +
           std::to_string(face.curves.count);
  for (const std::string& fault : {describePointFault(face.curves, FaceLayout::curveName), describeFault(face.curves),
                                   describeCrossing(face.curves), describeFeatureFault(face)})
    if (!fault.empty()) return fault;
  return {};
}

}  // namespace mien
