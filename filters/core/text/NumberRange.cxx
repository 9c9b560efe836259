#include "NumberRange.h"

#include <cmath>

#include "NumberText.h"

namespace mien {

namespace {

constexpr int largestCount = 10000;
constexpr std::string_view logarithmic = "log";
constexpr const char* advice = "give a number, BEGIN:END:COUNT or BEGIN:END:COUNTlog";

std::vector<std::string_view> splitAt(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (size_t end = text.find(separator); end != std::string_view::npos; end = text.find(separator)) {
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  parts.push_back(text);
  return parts;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

bool takeSuffix(std::string_view& text, std::string_view suffix) {
  if (text.size() < suffix.size() || text.substr(text.size() - suffix.size()) != suffix) return false;
  text.remove_suffix(suffix.size());
  return true;
}

/// The ends come out as they are written.
void appendSteps(double begin, double end, int count, bool log, std::vector<double>& numbers) {
  for (int i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / (count - 1);
    const double number = log ? begin * std::pow(end / begin, t) : begin + t * (end - begin);
    numbers.push_back(i == 0 ? begin : i == count - 1 ? end : number);
  }
}

std::string appendRange(std::string_view item, const std::vector<std::string_view>& parts,
                        std::vector<double>& numbers) {
  std::string_view countText = parts[2];
  const bool log = takeSuffix(countText, logarithmic);
  const auto begin = parseNumber(parts[0]), end = parseNumber(parts[1]);
  const auto count = parseWholeNumber(countText);
  if (!begin || !end || !count) return inQuotes(item) + " is not a range; " + advice;
  if (*count < 2 || *count > largestCount)
    return "the range " + inQuotes(item) + " has a count outside 2 .. " + std::to_string(largestCount);
  if (log && !(*begin > 0.0 && *end > 0.0))
    return "the range " + inQuotes(item) + " is logarithmic, so that both of its ends must be above 0";
  appendSteps(*begin, *end, static_cast<int>(*count), log, numbers);
  return {};
}

std::string appendItem(std::string_view item, std::vector<double>& numbers) {
  const auto parts = splitAt(item, ':');
  if (parts.size() == 3) return appendRange(item, parts, numbers);
  const auto number = parseNumber(item);
  if (!number) return inQuotes(item) + " is neither a number nor a range; " + advice;
  numbers.push_back(*number);
  return {};
}

}  // namespace

std::string parseNumberRange(std::string_view text, std::vector<double>& numbers) {
  std::vector<double> read;
  for (const std::string_view item : splitAt(text, ',')) {
    const std::string fault = appendItem(trimmed(item), read);
    if (!fault.empty()) return fault;
    if (read.size() > static_cast<size_t>(largestCount))
      return "the list has more than " + std::to_string(largestCount) + " numbers; ask for fewer";
  }
  numbers = std::move(read);
  return {};
}

}  // namespace mien
