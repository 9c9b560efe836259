#include "VectorScale.h"

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

const std::vector<double> factors = {1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0};
const std::vector<double> rangeFactors = {1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0};
const std::vector<double> tickFactors = {1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0};
constexpr double tickRounding = 1e-9;  // a number that misses a round one by rounding is it

double nextOf(const std::vector<double>& factors, double number) {
  const int power = static_cast<int>(std::floor(std::log10(number)));
  const double unit = std::pow(10.0, std::abs(power));
  const auto scaled = [&](double factor) { return power < 0 ? factor / unit : factor * unit; };  // 0.2, not 0.2 + 1e-17
  for (const double factor : factors)
    if (number <= scaled(factor) * (1.0 + tickRounding)) return scaled(factor);
  return scaled(10.0);
}

bool isRound(double step) {
  return std::abs(nextOf(tickFactors, step) - step) <= tickRounding * step;
}

bool isMultiple(double value, double step) {
  return std::abs(value / step - std::round(value / step)) <= tickRounding * std::max(1.0, std::abs(value / step));
}

/// Ends, and multiples of a round step at least half a step away from them.
std::vector<double> looseTicks(double begin, double end, int most) {
  std::vector<double> ticks = {begin};
  const double step = roundAbove((end - begin) / most);
  for (double i = std::ceil(begin / step + 0.5); i * step <= end - 0.5 * step; ++i) ticks.push_back(i * step);
  ticks.push_back(end);
  return ticks;
}

}  // namespace

double roundAbove(double number) {
  return nextOf({1.0, 2.0, 5.0}, number);
}

double roundBelow(double number) {
  const double above = roundAbove(number);
  if (above <= number * (1.0 + tickRounding)) return above;
  const double power = std::pow(10.0, std::floor(std::log10(above) + tickRounding)), factor = std::round(above / power);
  return factor == 5.0 ? above / 2.5 : above / 2.0;
}

double automaticScale(double longest, double room) {
  return longest > 0.0 && room > 0.0 ? nextOf(factors, longest / room) : 1.0;
}

double automaticRangeEnd(double largest) {
  return largest > 0.0 ? nextOf(rangeFactors, largest) : 1.0;
}

double automaticSpacing(double printed, double faceScale) {
  return faceScale > 0.0 ? nextOf(factors, printed / faceScale) : 1.0;
}

std::vector<double> rangeTicks(double begin, double end, int most) {
  for (int parts = std::max(1, most); parts > 0; --parts) {
    const double step = (end - begin) / parts;
    if (!isRound(step) || !isMultiple(begin, step)) continue;
    std::vector<double> ticks;
    for (int i = 0; i <= parts; ++i) ticks.push_back(std::round(begin / step + i) * step);
    return ticks;
  }
  return looseTicks(begin, end, std::max(1, most));
}

}  // namespace mien
