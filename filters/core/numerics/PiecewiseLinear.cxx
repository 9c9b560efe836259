#include "PiecewiseLinear.h"

#include <algorithm>
#include <cmath>

namespace mien {

std::string PiecewiseLinear::setBorders(const std::vector<double>& borders) {
  if (borders.size() < 2) return "borders need at least two values";
  if (borders.size() > mostBorders)
    return "there are " + std::to_string(borders.size()) + " borders; at most " + std::to_string(mostBorders) +
           " are read";
  if (!std::all_of(borders.begin(), borders.end(), [](double b) { return std::isfinite(b); }))
    return "borders must be finite numbers";
  if (std::adjacent_find(borders.begin(), borders.end(), [](double a, double b) { return !(a < b); }) != borders.end())
    return "borders must ascend";
  if (std::find(borders.begin(), borders.end(), 0.0) == borders.end()) return "one of the borders must be 0";
  borders_ = borders;
  return {};
}

double PiecewiseLinear::length(int interval, double value) const {
  const bool upwards = value >= 0.0;
  const int outermost = upwards ? intervals() - 1 : 0;
  // All of the walk lies beyond the borders when 0 is the outer one.
  const double outerBorder = upwards ? borders_.back() : borders_.front();
  if (outerBorder == 0.0) return interval == outermost ? value : 0.0;
  double from = borders_[interval], to = borders_[interval + 1];
  if (interval == outermost) (upwards ? to : from) = upwards ? std::max(to, value) : std::min(from, value);
  if (upwards) return std::max(0.0, std::min(value, to) - std::max(from, 0.0));
  return std::min(0.0, std::max(value, from) - std::min(to, 0.0));
}

}  // namespace mien
