#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "FacialRegions.h"
#include "Require.h"

using namespace mien;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FacialRegions regions;
  const std::string fault = regions.parse(std::string(reinterpret_cast<const char*>(data), size));
  if (!fault.empty()) {
    require(regions.version() == 0);
    return 0;
  }
  for (const Eigen::Vector2d& point : {Eigen::Vector2d(0.0, -2.2), Eigen::Vector2d(1.0, 0.1)})
    for (const FaceSide& side : {FaceSide{1.0, 0.0}, FaceSide{-0.5, -1.0}}) {
      double sum = 0.0;
      for (const double weight : regions.weights(point, side)) sum += weight;
      require(std::abs(sum - 1.0) < 1e-9);
      const int nearest = regions.nearest(point, side);
      require(nearest >= 1 && nearest <= FacialRegions::count &&
              regions.mirrored(regions.mirrored(nearest)) == nearest);
    }
  return 0;
}
