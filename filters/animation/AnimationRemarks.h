#pragma once

#include <algorithm>
#include <set>

#include "FaceAnimator.h"

namespace mien {

/// What should be known of all frames of a face, a table and a file that were shown so far.
struct AnimationRemarks {
  std::set<int> ignoredFAPs;    ///< that move nothing
  double largestPushed = 0.0;   ///< mm, of a curve without room by its neighbour
  double largestClamped = 0.0;  ///< mm, of a crossing of lips or lids that was undone
  double smallestKept = 1.0;    ///< share of its movement that the whole face kept

  /// The frame that the animator made last.
  /// @return whether it has ignored FAPs that were not known
  bool add(const FaceAnimator& animator, const FAPFrame& frame) {
    largestPushed = std::max(largestPushed, animator.pushed());
    largestClamped = std::max(largestClamped, animator.contactClamped());
    smallestKept = std::min(smallestKept, animator.keptShare());
    const std::size_t known = ignoredFAPs.size();
    for (const int fap : animator.ignoredFAPs(frame)) ignoredFAPs.insert(fap);
    return ignoredFAPs.size() > known;
  }
};

}  // namespace mien
