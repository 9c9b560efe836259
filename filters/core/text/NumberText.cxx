#include "NumberText.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace mien {

namespace {

constexpr std::size_t longestQuotation = 40;

// A plain comparison per character: find_first_of calls memchr for each, which took most of the time of reading a file.
bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

std::string_view withoutPlus(std::string_view text) {
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  return plus ? text.substr(1) : text;
}

}  // namespace

std::optional<double> parseNumber(std::string_view text) {
  text = withoutPlus(text);
  double number = 0.0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (fault == std::errc::result_out_of_range) number = outOfRangeNumber(text);
  if (fault == std::errc::invalid_argument || end != text.data() + text.size() || !std::isfinite(number))
    return std::nullopt;
  return number;
}

double outOfRangeNumber(std::string_view text) {
  const std::size_t exponentAt = std::min(text.find_first_of("eE"), text.size());
  const std::string_view digits = text.substr(0, exponentAt);
  const std::size_t dot = std::min(digits.find('.'), digits.size()), first = digits.find_first_of("123456789");
  if (first == std::string_view::npos) return 0.0;
  const double place = static_cast<double>(dot) - static_cast<double>(first);
  const std::string_view exponent = text.substr(std::min(exponentAt + 1, text.size()));
  const bool isSmall = place + static_cast<double>(parseWholeNumber(exponent).value_or(0)) < 0.0;
  const double size = isSmall ? 0.0 : std::numeric_limits<double>::infinity();
  return text.substr(0, 1) == "-" ? -size : size;
}

std::optional<std::int64_t> parseWholeNumber(std::string_view text) {
  using Limits = std::numeric_limits<std::int64_t>;
  text = withoutPlus(text);
  std::int64_t number = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (fault == std::errc::invalid_argument || end != text.data() + text.size()) return std::nullopt;
  if (fault == std::errc::result_out_of_range) return text[0] == '-' ? Limits::min() : Limits::max();
  return number;
}

void appendNumber(std::string& text, double number) {
  char digits[32];  // the shortest form of a double has at most 24 characters
  const auto result = std::to_chars(digits, digits + sizeof digits, number);
  text.append(digits, result.ptr);
}

std::string numberText(double number) {
  std::string text;
  appendNumber(text, number);
  return text;
}

std::string roundedText(double number) {
  constexpr int mostDecimals = 12;
  if (!std::isfinite(number)) return std::isnan(number) ? "nan" : number > 0.0 ? "inf" : "-inf";
  const int decimals = 2 - static_cast<int>(std::floor(std::log10(std::max(std::abs(number), 1e-12))));
  if (decimals < 0) {
    const double step = std::pow(10.0, -decimals);
    return numberText(std::round(number / step) * step);
  }
  std::array<char, 64> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed,
                                 std::min(decimals, mostDecimals));
  const std::string rounded(text.data(), end.ptr);
  return numberText(parseNumber(rounded).value_or(number));
}

void splitAtBlanks(std::string_view line, std::vector<std::string_view>& parts) {
  parts.clear();
  for (auto begin = std::find_if_not(line.begin(), line.end(), isBlank); begin != line.end();) {
    const auto end = std::find_if(begin, line.end(), isBlank);
    parts.push_back(line.substr(begin - line.begin(), end - begin));
    begin = std::find_if_not(end, line.end(), isBlank);
  }
}

std::string inQuotes(std::string_view text) {
  std::string shown(text.substr(0, longestQuotation));
  const auto isControl = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  std::replace_if(shown.begin(), shown.end(), isControl, '?');
  return "'" + shown + (text.size() > longestQuotation ? "...'" : "'");
}

}  // namespace mien
