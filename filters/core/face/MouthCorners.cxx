#include "MouthCorners.h"

#include <algorithm>
#include <cmath>

#include "FaceLayout.h"

namespace mien {

namespace {

/// Lips nearer than this touch, mm.
constexpr double contact = 1e-9;

}  // namespace

MouthCorners::MouthCorners(const FaceCurves& face) {
  const FeaturePoint* left = face.feature("2.4");
  const FeaturePoint* right = face.feature("2.5");
  if (left && right) {
    begin = std::min(left->v, right->v);
    end = std::max(left->v, right->v);
    return;
  }
  const auto gap = (face.curves.curve(FaceLayout::upperLip) - face.curves.curve(FaceLayout::lowerLip)).eval();
  int first = -1, last = -1;
  for (int j = 0; j < gap.rows(); ++j)
    if (gap.row(j).norm() > contact) {
      first = first < 0 ? j : first;
      last = j;
    }
  const double step = 2.0 * M_PI / face.curves.pointsPerCurve;
  if (first >= 0) {
    begin = (first - 1) * step;
    end = (last + 1) * step;
  }
}

}  // namespace mien
