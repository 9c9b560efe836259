#include "DeviationText.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

namespace mien {

namespace {

constexpr int usualDecimals = 3;

std::string withDecimals(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  if (std::abs(value) * scale < 0.5) value = 0.0;
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::fixed << std::setprecision(decimals) << value;
  return text.str();
}

/// Decimals that leave `digits` significant ones of a number above 0.
int decimalsOf(double number, int digits) {
  return std::clamp(digits - 1 - static_cast<int>(std::floor(std::log10(number))), 0, mostDecimals);
}

int decimalsFor(double deviation) {
  if (!(deviation > 0.0)) return usualDecimals;
  const double leading = deviation / std::pow(10.0, std::floor(std::log10(deviation)));
  return decimalsOf(deviation, leading < 1.95 ? 2 : 1);
}

}  // namespace

std::string conciseText(double value, double deviation) {
  const int decimals = decimalsFor(deviation);
  const double last = std::round(deviation * std::pow(10.0, decimals));
  return withDecimals(value, decimals) + "(" +
         (deviation < 1.0 ? withDecimals(last, 0) : withDecimals(deviation, decimals)) + ")";
}

std::string rangeText(double value, double deviation, const std::string& sign) {
  const int decimals = decimalsFor(deviation);
  return withDecimals(value, decimals) + sign + withDecimals(deviation, decimals);
}

std::string fixedText(double value) {
  const double size = std::abs(value);
  if (size < std::pow(10.0, -mostDecimals)) return withDecimals(0.0, usualDecimals);
  std::string text = withDecimals(value, std::max(usualDecimals, decimalsOf(size, 2)));
  // A number that was printed with three decimals stays as it was printed.
  while (text.back() == '0' && text.size() - text.find('.') > usualDecimals + 1) text.pop_back();
  return text;
}

}  // namespace mien
