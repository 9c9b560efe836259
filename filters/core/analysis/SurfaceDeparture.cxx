#include "SurfaceDeparture.h"

#include <algorithm>

#include "FaceArea.h"

namespace mien {

SurfaceDeparture::SurfaceDeparture(const FaceSample& sample, const FaceSample& reference) {
  const double squared = integrate(reference, [&](int row, int column) {
    const double distance = (sample.point(row, column) - reference.point(row, column)).norm();
    maximum = std::max(maximum, distance);
    return distance * distance * reference.areaElement(row, column);
  });
  rms = std::sqrt(squared / faceArea(reference));
}

}  // namespace mien
