#include "RoundedUp.h"

#include <algorithm>
#include <cmath>

namespace mien {

double roundedUp(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(std::max(value, 1e-9))));
  for (double step : {1.0, 2.0, 5.0})
    if (step * decade >= value) return step * decade;
  return 10.0 * decade;
}

}  // namespace mien
