#include "MonotoneInterpolant.h"

#include <algorithm>
#include <cstddef>

namespace mien {

namespace {

/// Slope at a knot between two intervals of widths h0, h1 and mean slopes d0, d1.
double innerSlope(double h0, double h1, double d0, double d1) {
  if (d0 * d1 <= 0.0) return 0.0;
  const double w0 = 2.0 * h1 + h0, w1 = h1 + 2.0 * h0;
  return (w0 + w1) / (w0 / d0 + w1 / d1);
}

}  // namespace

MonotoneInterpolant::MonotoneInterpolant(std::vector<std::pair<double, double>> knots) {
  std::sort(knots.begin(), knots.end());
  for (std::size_t i = 0; i < knots.size();) {
    const std::size_t first = i;
    double sum = 0.0;
    for (; i < knots.size() && knots[i].first == knots[first].first; ++i) sum += knots[i].second;
    x_.push_back(knots[first].first);
    y_.push_back(sum / static_cast<double>(i - first));
  }
  slope_.assign(x_.size(), 0.0);
  for (std::size_t i = 1; i + 1 < x_.size(); ++i) {
    const double h0 = x_[i] - x_[i - 1], h1 = x_[i + 1] - x_[i];
    slope_[i] = innerSlope(h0, h1, (y_[i] - y_[i - 1]) / h0, (y_[i + 1] - y_[i]) / h1);
  }
}

double MonotoneInterpolant::operator()(double x) const {
  if (x_.empty()) return 0.0;
  if (x <= x_.front()) return y_.front();
  if (x >= x_.back()) return y_.back();
  const std::size_t i = std::upper_bound(x_.begin(), x_.end(), x) - x_.begin() - 1;
  const double h = x_[i + 1] - x_[i], t = (x - x_[i]) / h;
  const double rise = t * t * (3.0 - 2.0 * t);
  return y_[i] + (y_[i + 1] - y_[i]) * rise + h * t * (1.0 - t) * ((1.0 - t) * slope_[i] - t * slope_[i + 1]);
}

}  // namespace mien
