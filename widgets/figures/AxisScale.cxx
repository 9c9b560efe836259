#include "AxisScale.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace mien {

namespace {

constexpr double automaticSpan = 50.0;                     // from here on small values vanish on a linear axis
constexpr double mostPlainNumber = 1e6;                    // from here on numbers are written as powers of ten ...
constexpr int leastPlainDecade = -3, mostPlainDecade = 3;  // ... and an axis of decades that leaves these
constexpr double leastPlainNumber = 1e-4;
constexpr double rounding = 1e-9;  // of a step: ticks that miss the end by rounding still belong to the axis

std::string superscript(int number) {
  static const char* const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = number < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(number))) text += digits[digit - '0'];
  return text;
}

/// The smallest of 1, 2, 5 times a power of ten that is no smaller.
double niceStep(double step) {
  const double power = std::pow(10.0, std::floor(std::log10(step)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (step <= factor * power * (1.0 + rounding)) return factor * power;
  return 10.0 * power;
}

std::string powerText(double value) {
  return "10" + superscript(static_cast<int>(std::lround(std::log10(value))));
}

std::string plainText(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, std::abs(value));
  for (char* c = text; *c; ++c)
    if (*c == ',') *c = '.';  // whatever the user's locale
  const bool isZero = std::string(text).find_first_not_of("0.") == std::string::npos;
  return (value < 0.0 && !isZero ? "−" : "") + std::string(text);
}

struct Range {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
  bool empty() const { return least > most; }
};

Range rangeOf(const std::vector<double>& values, bool positiveOnly) {
  Range range;
  for (const double value : values) {
    if (!std::isfinite(value) || (positiveOnly && value <= 0.0)) continue;
    range.least = std::min(range.least, value);
    range.most = std::max(range.most, value);
  }
  return range;
}

bool isLogarithmic(const ChartAxis& axis, const std::vector<double>& values) {
  if (axis.scale != ChartAxis::Scale::Automatic) return axis.scale == ChartAxis::Scale::Logarithmic;
  const Range all = rangeOf(values, false), positive = rangeOf(values, true);
  return !positive.empty() && all.least >= 0.0 && positive.most > automaticSpan * positive.least;
}

/// Room around linear values: up to the next step of about a fifth of them.
void widen(Range& range) {
  if (range.least == range.most) {
    const double half = range.least == 0.0 ? 0.5 : 0.5 * std::abs(range.least);
    range = {range.least - half, range.most + half};
  }
  const double step = niceStep((range.most - range.least) / 5.0);
  range.least = step * std::floor(range.least / step + rounding);
  range.most = step * std::ceil(range.most / step - rounding);
}

void widenToDecades(Range& range) {
  range.least = std::pow(10.0, std::floor(std::log10(range.least) + rounding));
  range.most = std::pow(10.0, std::ceil(std::log10(range.most) - rounding));
  if (range.least == range.most) range.most *= 10.0;
}

}  // namespace

std::string tickText(double value, double step) {
  const double size = std::abs(value);
  if (size >= mostPlainNumber || (size > 0.0 && std::abs(step) < leastPlainNumber)) {
    const int power = static_cast<int>(std::floor(std::log10(size) + rounding));
    const double factor = value / std::pow(10.0, power);
    if (std::abs(factor - 1.0) < rounding) return "10" + superscript(power);
    return tickText(factor, std::max(step / std::pow(10.0, power), 0.001)) + "·10" + superscript(power);
  }
  int decimals = 0;
  for (double unit = step; decimals < 6 && std::abs(unit - std::round(unit)) > 1e-6 * unit; unit *= 10.0) ++decimals;
  return plainText(value, decimals);
}

AxisScale AxisScale::around(const ChartAxis& axis, const std::vector<double>& values, bool withZero) {
  if (!axis.categories.empty()) return AxisScale(-0.5, axis.categories.size() - 0.5, false);
  const bool logarithmic = isLogarithmic(axis, values);
  Range range = rangeOf(values, logarithmic);
  if (range.empty()) range = logarithmic ? Range{1.0, 10.0} : Range{0.0, 1.0};
  if (!logarithmic && (withZero || (range.least > 0.0 && range.least < 0.5 * range.most)))
    range.least = std::min(range.least, 0.0);
  if (!logarithmic && withZero) range.most = std::max(range.most, 0.0);
  const bool room = !axis.endsWithData || range.least == range.most;
  if (room) logarithmic ? widenToDecades(range) : widen(range);
  return AxisScale(axis.begin.value_or(range.least), axis.end.value_or(range.most), logarithmic);
}

double AxisScale::fraction(double value) const {
  if (!logarithmic_) return (value - begin_) / (end_ - begin_);
  if (value <= 0.0) return 0.0;
  return std::log(value / begin_) / std::log(end_ / begin_);
}

std::vector<AxisTick> AxisScale::ticks(const ChartAxis& axis, int most) const {
  std::vector<AxisTick> ticks;
  for (size_t i = 0; i < axis.categories.size(); ++i) ticks.push_back({static_cast<double>(i), axis.categories[i]});
  if (!ticks.empty()) return ticks;
  if (logarithmic_) return decadeTicks(most);
  if (axis.step <= 0.0) return linearTicks(niceStep((end_ - begin_) / std::max(1, most)), 0.0);
  return linearTicks(axis.step, axis.begin.value_or(0.0));
}

std::vector<AxisTick> AxisScale::linearTicks(double step, double origin) const {
  std::vector<AxisTick> ticks;
  const double first = std::ceil((begin_ - origin) / step - rounding),
               last = std::floor((end_ - origin) / step + rounding);
  for (double i = first; i <= last; ++i) ticks.push_back({origin + i * step, tickText(origin + i * step, step)});
  return ticks;
}

std::vector<AxisTick> AxisScale::decadeTicks(int most) const {
  const double span = std::log10(end_ / begin_);
  if (span < 1.0) return linearTicks(niceStep((end_ - begin_) / std::max(1, most)), 0.0);
  const int first = static_cast<int>(std::floor(std::log10(begin_) + rounding));
  const int last = static_cast<int>(std::floor(std::log10(end_) + rounding));
  const int every =
      std::max(1, static_cast<int>(std::ceil((last - first + 1) / static_cast<double>(std::max(1, most)))));
  const bool powers = first < leastPlainDecade || last > mostPlainDecade;  // all of an axis alike
  std::vector<AxisTick> ticks;
  for (int decade = first; decade <= last; ++decade) {
    const double value = std::pow(10.0, decade);
    const bool named = (decade - first) % every == 0;
    if (value >= begin_ * (1.0 - rounding))
      ticks.push_back({value, !named ? "" : powers ? powerText(value) : tickText(value, value)});
    if (every == 1) appendMinorTicks(decade, 3 * (last - first + 1) <= most, ticks);
  }
  return ticks;
}

void AxisScale::appendMinorTicks(int decade, bool labelled, std::vector<AxisTick>& ticks) const {
  for (int digit = 2; digit < 10; ++digit) {
    const double unit = std::pow(10.0, decade), value = digit * unit;
    if (value < begin_ * (1.0 - rounding) || value > end_ * (1.0 + rounding)) continue;
    ticks.push_back({value, labelled && (digit == 2 || digit == 5) ? tickText(value, unit) : ""});
  }
}

}  // namespace mien
