#include "WillmoreEnergy.h"

#include "SurfaceCurvature.h"

namespace mien {

double willmoreEnergy(const FaceSample& sample) {
  return integrate(sample, [&](int row, int column) {
    const double mean = SurfaceCurvature(sample.jet(row, column)).mean;
    return mean * mean * sample.areaElement(row, column);
  });
}

}  // namespace mien
