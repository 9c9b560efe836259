#include "RowNumbers.h"

#include <algorithm>

#include "NumberText.h"

namespace mien {

namespace {

constexpr std::size_t mostNames = 6;  // said in one sentence

}  // namespace

std::optional<double> numberIn(const CommaReader& reader, std::size_t column, std::string& fault) {
  if (column >= reader.cells().size() || reader.cells()[column].empty()) return std::nullopt;
  const std::optional<double> number = parseNumber(reader.cells()[column]);
  if (!number) fault = reader.columnName(column) + " is " + inQuotes(reader.cells()[column]) + "; give a finite number";
  return number;
}

std::string describeUnused(const std::vector<std::string>& names) {
  if (names.empty()) return {};
  std::string text = names.size() == 1 ? "column " : "columns ";
  for (std::size_t i = 0; i < std::min(names.size(), mostNames); ++i) text += (i ? ", " : "") + inQuotes(names[i]);
  if (names.size() > mostNames) text += " and " + std::to_string(names.size() - mostNames) + " more";
  return text + (names.size() == 1 ? " is not used" : " are not used");
}

std::string describeWidth(const CommaReader& reader) {
  if (reader.cells().size() == reader.header().size()) return {};
  return "there are " + std::to_string(reader.cells().size()) + " cells under " +
         std::to_string(reader.header().size()) + " columns; give one for each";
}

}  // namespace mien
