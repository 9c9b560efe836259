#include "VectorScale.h"

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

const std::vector<double> factors = {1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0};
constexpr double rounding = 1e-9;  // a number that misses a round one by rounding is it

double nextOf(const std::vector<double>& factors, double number) {
  const int power = static_cast<int>(std::floor(std::log10(number)));
  const double unit = std::pow(10.0, std::abs(power));
  const auto scaled = [&](double factor) { return power < 0 ? factor / unit : factor * unit; };  // 0.2, not 0.2 + 1e-17
  for (const double factor : factors)
    if (number <= scaled(factor) * (1.0 + rounding)) return scaled(factor);
  return scaled(10.0);
}

}  // namespace

double roundAbove(double number) {
  return nextOf({1.0, 2.0, 5.0}, number);
}

double roundBelow(double number) {
  const double above = roundAbove(number);
  if (above <= number * (1.0 + rounding)) return above;
  const double power = std::pow(10.0, std::floor(std::log10(above) + rounding)), factor = std::round(above / power);
  return factor == 5.0 ? above / 2.5 : above / 2.0;
}

double automaticScale(double longest, double room) {
  return longest > 0.0 && room > 0.0 ? nextOf(factors, longest / room) : 1.0;
}

double automaticRangeEnd(double largest) {
  return largest > 0.0 ? nextOf(factors, largest) : 1.0;
}

}  // namespace mien
