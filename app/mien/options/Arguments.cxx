#include "Arguments.h"

#include <charconv>
#include <cmath>
#include <sstream>

#include "Failure.h"

namespace mien {

namespace {

/// True when the whole text is one number of that type.
template <class Number>
bool parse(const std::string& text, Number& value) {
  const char* begin = text.data() + (text.size() > 1 && text[0] == '+' ? 1 : 0);
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(begin, end, value);
  return result.ec == std::errc() && result.ptr == end;
}

}  // namespace

std::string isNotEmpty(const std::string& text) {
  return text.empty() ? "it is empty; give a value or leave the option out" : "";
}

double parseNumber(const std::string& option, const std::string& text) {
  double value = 0.0;
  if (!parse(text, value) || !std::isfinite(value))
    throw ValueFailure(option + " '" + text + "' is no number; write it as 0.8 or 1e-3");
  return value;
}

int parseWholeNumber(const std::string& option, const std::string& text) {
  int value = 0;
  if (!parse(text, value)) throw ValueFailure(option + " '" + text + "' is no whole number");
  return value;
}

double parseMillimetres(const std::string& option, const std::string& text) {
  static const std::pair<const char*, double> units[] = {{"mm", 1.0}, {"cm", 10.0}, {"in", 25.4}, {"pt", 25.4 / 72.0}};
  double factor = 1.0;
  std::string number = text;
  for (const auto& [unit, millimetres] : units)
    if (text.size() > 2 && text.compare(text.size() - 2, 2, unit) == 0) {
      factor = millimetres;
      number.resize(text.size() - 2);
    }
  double value = 0.0;
  if (!parse(number, value) || !std::isfinite(value))
    throw ValueFailure(option + " '" + text +
                       "' is no length; write a number in mm such as 85, or with mm, cm, in or pt");
  if (!(value > 0.0)) throw ValueFailure(option + " '" + text + "' is not above 0; a length is written as 85 or 85mm");
  return factor * value;
}

std::vector<std::string> splitText(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator)
      parts.emplace_back();
    else
      parts.back().push_back(c);
  }
  return parts;
}

std::pair<int, int> parseSize(const std::string& option, const std::string& text) {
  const std::vector<std::string> parts = splitText(text, 'x');
  std::pair<int, int> size;
  const bool valid = parts.size() == 2 && parse(parts[0], size.first) && parse(parts[1], size.second);
  if (!valid || size.first < 1 || size.second < 1)
    throw ValueFailure(option + " '" + text + "' is no size; write two whole numbers such as 56x40");
  return size;
}

}  // namespace mien
