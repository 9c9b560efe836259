#include "FaceArea.h"

namespace mien {

double faceArea(const FaceSample& sample) {
  return integrate(sample, [&](int row, int column) { return sample.areaElement(row, column); });
}

}  // namespace mien
