#include "LargestSeamAngle.h"

#include <algorithm>

#include "SeamMeasures.h"

namespace mien {

namespace {

/// Patches that are further apart than this do not meet, mm.
constexpr double contact = 1e-6;

}  // namespace

double largestSeamAngle(const FaceSample& sample) {
  double largest = 0.0;
  for (int below = 1; below < FaceLayout::patchCount; ++below)
    for (int column = 0; column < sample.columnCount(); ++column) {
      const int row = sample.firstRow(below);
      const SeamMeasures seam(sample.jet(row - 1, column), sample.jet(row, column));
      const bool lipsApart = FaceLayout::firstCurve[below] == FaceLayout::lowerLip && seam.g0 > contact;
      if (!lipsApart && seam.g1 > largest) largest = seam.g1;
    }
  return largest;
}

}  // namespace mien
