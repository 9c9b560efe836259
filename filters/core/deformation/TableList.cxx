#include "TableList.h"

#include <cmath>
#include <sstream>

#include "NumberText.h"

namespace mien {

namespace {

std::string parseOne(const std::string& text, WeightedName& table) {
  const auto colon = text.rfind(':'), slash = text.find_last_of("/\\");
  table = {text, 1.0};
  if (colon == std::string::npos || (slash != std::string::npos && colon < slash)) return {};
  const auto weight = parseNumber(std::string_view(text).substr(colon + 1));
  if (!weight) return "the weight in " + inQuotes(text) + " is no finite number; 1 is the table as it is";
  if (std::abs(*weight) > largestTableWeight)
    return "the weight in " + inQuotes(text) + " is outside -2 .. 2; 1 is the table as it is";
  table = {text.substr(0, colon), *weight};
  return {};
}

}  // namespace

std::string parseTableList(const std::string& text, std::vector<WeightedName>& tables) {
  std::istringstream parts(text);
  std::vector<WeightedName> parsed;
  for (std::string part; std::getline(parts, part, ',');) {
    parsed.emplace_back();
    const std::string fault = parseOne(part, parsed.back());
    if (!fault.empty()) return fault;
    if (parsed.back().name.empty()) return "a table in " + inQuotes(text) + " has no name";
  }
  tables = parsed;
  return {};
}

}  // namespace mien
