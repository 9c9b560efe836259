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
constexpr int leastTicks = 2;      // with a text: fewer do not tell a scale
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

/// The next smaller one.
double finerStep(double step) {
  return niceStep(step / 2.6);
}

int decadeOf(double value) {
  return static_cast<int>(std::floor(std::log10(value) + rounding));
}

/// 1, 2 or 5 times a power of ten: "10⁻⁶", "2·10⁻⁶".
std::string powerText(int digit, int decade) {
  return (digit == 1 ? "" : std::to_string(digit) + "·") + "10" + superscript(decade);
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

/// What stands on a logarithmic axis: 1 to 9 times a power of ten.
struct DecadePlace {
  int digit, decade;
  double value() const { return digit * std::pow(10.0, decade); }
};

bool isPower(const DecadePlace& place) {
  return place.digit == 1;
}

bool isRound(const DecadePlace& place) {
  return place.digit == 1 || place.digit == 2 || place.digit == 5;
}

std::vector<DecadePlace> placesBetween(double begin, double end) {
  std::vector<DecadePlace> places;
  for (int decade = decadeOf(begin); decade <= decadeOf(end); ++decade)
    for (int digit = 1; digit < 10; ++digit) {
      const DecadePlace place = {digit, decade};
      if (place.value() >= begin * (1.0 - rounding) && place.value() <= end * (1.0 + rounding)) places.push_back(place);
    }
  return places;
}

/// Ticks of all places, or without `minor` of the powers of ten alone; all texts of an axis are written alike.
template <class Named>
std::vector<AxisTick> namedTicks(const std::vector<DecadePlace>& places, const Named& isNamed, bool minor) {
  const auto needsPower = [&](const DecadePlace& place) {
    return isNamed(place) && (place.decade < leastPlainDecade || place.decade > mostPlainDecade);
  };
  const bool powers = std::any_of(places.begin(), places.end(), needsPower);
  std::vector<AxisTick> ticks;
  for (const DecadePlace& place : places) {
    if (!minor && !isPower(place)) continue;
    const std::string text =
        powers ? powerText(place.digit, place.decade) : tickText(place.value(), std::pow(10.0, place.decade));
    ticks.push_back({place.value(), isNamed(place) ? text : ""});
  }
  return ticks;
}

/// With the decimals that a step needs.
std::string steppedText(double value, double step) {
  int decimals = 0;
  for (double unit = step; decimals < 6 && std::abs(unit - std::round(unit)) > 1e-6 * unit; unit *= 10.0) ++decimals;
  return plainText(value, decimals);
}

}  // namespace

/// What is before a power of ten is written as it is, however small the step: else large numbers close together would
/// be taken apart for ever.
std::string tickText(double value, double step) {
  const double size = std::abs(value);
  if (!std::isfinite(value)) return {};
  if (size < rounding * std::abs(step) && std::abs(step) < leastPlainNumber) return "0";
  if (size >= mostPlainNumber || (size > 0.0 && std::abs(step) < leastPlainNumber)) {
    const int power = static_cast<int>(std::floor(std::log10(size) + rounding));
    const double factor = value / std::pow(10.0, power);
    if (std::abs(factor - 1.0) < rounding) return "10" + superscript(power);
    return steppedText(factor, std::max(step / std::pow(10.0, power), 1e-6)) + "·10" + superscript(power);
  }
  return steppedText(value, step);
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
  if (logarithmic_) return decadeTicks(std::max(1, most));
  if (axis.step > 0.0) ticks = linearTicks(axis.step, axis.begin.value_or(0.0));
  return static_cast<int>(ticks.size()) < leastTicks ? evenTicks(std::max(1, most)) : ticks;
}

std::vector<AxisTick> AxisScale::linearTicks(double step, double origin) const {
  std::vector<AxisTick> ticks;
  const double first = std::ceil((begin_ - origin) / step - rounding),
               last = std::floor((end_ - origin) / step + rounding);
  for (double i = first; i <= last; ++i) ticks.push_back({origin + i * step, tickText(origin + i * step, step)});
  return ticks;
}

/// One number does not tell a scale: steps get finer until there are two.
std::vector<AxisTick> AxisScale::evenTicks(int most) const {
  const double span = end_ - begin_;
  if (!(span > 0.0) || !std::isfinite(span)) return {{begin_, tickText(begin_, begin_)}};
  double step = niceStep(span / most);
  std::vector<AxisTick> ticks = linearTicks(step, 0.0);
  while (static_cast<int>(ticks.size()) < leastTicks && step > rounding * span)
    ticks = linearTicks(step = finerStep(step), 0.0);
  return ticks;
}

/// Powers of ten, all or every few; 1, 2 and 5 times these where there is room for them, or one power alone.
std::vector<AxisTick> AxisScale::decadeTicks(int most) const {
  const std::vector<DecadePlace> places = placesBetween(begin_, end_);
  const int powers = static_cast<int>(std::count_if(places.begin(), places.end(), isPower));
  const int rounds = static_cast<int>(std::count_if(places.begin(), places.end(), isRound));
  if (powers < leastTicks || rounds <= most)
    return rounds > leastTicks ? namedTicks(places, isRound, true) : evenTicks(most);
  const int every = std::min(powers - 1, (powers + most - 1) / most);
  const int first = std::find_if(places.begin(), places.end(), isPower)->decade;
  const auto isNamed = [&](const DecadePlace& place) { return isPower(place) && (place.decade - first) % every == 0; };
  return namedTicks(places, isNamed, every == 1);
}

}  // namespace mien
