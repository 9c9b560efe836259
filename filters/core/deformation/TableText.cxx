#include "TableText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <vector>

#include "CommaText.h"
#include "LineReader.h"
#include "NumberText.h"

namespace mien {

namespace {

using Cells = std::vector<std::string>;
constexpr int coefficientCount = 12;
constexpr int largestCount = 1'000'000;  // of recordings
constexpr const char* beyondLimit =
    " is beyond -100 .. 100, which no face reaches; coefficients are in units of half the distance between the pupils";

struct TableColumns {
  std::size_t count = 0;
  int region = -1, displacement = -1, n = -1;
  std::array<int, coefficientCount> values{}, deviations{};
  bool hasDeviations = false;

  std::string find(const Cells& header) {
    count = header.size();
    region = columnNamed(header, "region");
    displacement = columnNamed(header, "displacement");
    n = columnNamed(header, "n");
    if (region < 0) return "the header must name the columns region, a1 .. a6 and b1 .. b6" + separatorHint(header);
    int found = 0;
    for (int i = 0; i < coefficientCount; ++i) {
      values[i] = columnNamed(header, coefficientName(i));
      deviations[i] = columnNamed(header, coefficientName(i) + "_sd");
      if (values[i] < 0) return "the header does not name column " + coefficientName(i);
      found += deviations[i] >= 0;
    }
    hasDeviations = found == coefficientCount;
    return found == 0 || hasDeviations ? "" : "give a1_sd .. b6_sd for all twelve coefficients, or for none";
  }
};

/// Collects the rows of a table.
struct TableRows {
  TableColumns columns;
  DeformationTable table;
  std::array<bool, DeformationTable::regionCount> seen{};

  std::string add(const Cells& cells) {
    if (cells.size() != columns.count)
      return "there are " + std::to_string(cells.size()) + " cells under " + std::to_string(columns.count) + " columns";
    const auto region = parseWholeNumber(cells[columns.region]);
    if (!region || *region < 1 || *region > DeformationTable::regionCount)
      return inQuotes(cells[columns.region]) + " is no region; regions run from 1 to 16";
    const int index = static_cast<int>(*region) - 1;
    if (seen[index]) return "region " + std::to_string(*region) + " is given twice; remove one of them";
    seen[index] = true;
    for (int i = 0; i < coefficientCount; ++i) {
      const std::string fault = addCoefficient(cells, index, i);
      if (!fault.empty()) return "region " + std::to_string(*region) + ": " + fault;
    }
    if (columns.n >= 0 && !addCount(cells[columns.n], index))
      return "region " + std::to_string(*region) + ": " + inQuotes(cells[columns.n]) +
             " in column n is no number of recordings; give 0 (no point was there) to 1000000";
    return columns.displacement < 0 ? "" : addDisplacement(cells[columns.displacement]);
  }

 private:
  std::string addCoefficient(const Cells& cells, int region, int i) {
    const auto value = parseNumber(cells[columns.values[i]]);
    if (!value) return inQuotes(cells[columns.values[i]]) + " in column " + coefficientName(i) + " is no finite number";
    if (std::abs(*value) > DeformationTable::largestCoefficient)
      return inQuotes(cells[columns.values[i]]) + " in column " + coefficientName(i) + beyondLimit;
    table.maps[region].coefficients(i / 6, i % 6) = *value;
    if (!columns.hasDeviations) return {};
    const auto deviation = parseNumber(cells[columns.deviations[i]]);
    if (!deviation || *deviation < 0.0 || *deviation > DeformationTable::largestCoefficient)
      return inQuotes(cells[columns.deviations[i]]) + " in column " + coefficientName(i) +
             "_sd is no deviation; give a number from 0 to 100";
    table.deviations->at(region)(i / 6, i % 6) = *deviation;
    return {};
  }

  bool addCount(const std::string& cell, int region) {
    const auto count = parseWholeNumber(cell);
    if (!count || *count < 0 || *count > largestCount) return false;
    table.counts->at(region) = static_cast<int>(*count);
    return true;
  }

  std::string addDisplacement(const std::string& cell) {
    const auto value = parseNumber(cell);
    if (!value || *value < 0.0 || *value > DeformationTable::largestCoefficient)
      return inQuotes(cell) + " is no displacement; give pupil units from 0 to 100";
    table.largestDisplacement = std::max(table.largestDisplacement, *value);
    return {};
  }
};

}  // namespace

std::string parseTable(const std::string& text, DeformationTable& table) {
  LineReader lines(text);
  if (!lines.next()) return "1: the file is empty; give a header and 16 rows";
  TableRows rows;
  std::string fault = rows.columns.find(splitAtCommas(lines.line()));
  if (rows.columns.hasDeviations) rows.table.deviations.emplace();
  if (rows.columns.n >= 0) rows.table.counts.emplace();
  while (fault.empty() && lines.next()) fault = rows.add(splitAtCommas(lines.line()));
  const auto missing = std::find(rows.seen.begin(), rows.seen.end(), false);
  if (fault.empty() && missing != rows.seen.end())
    fault = "region " + std::to_string(missing - rows.seen.begin() + 1) + " is missing; a table has 16";
  if (!fault.empty()) return std::to_string(lines.number()) + ": " + fault;
  table = rows.table;
  return {};
}

std::string writeTable(const DeformationTable& table, const std::string& comment) {
  std::istringstream lines(comment);
  std::string text;
  for (std::string line; std::getline(lines, line);) text += "# " + line + "\n";
  text += "region";
  for (int i = 0; i < coefficientCount; ++i) text += "," + coefficientName(i);
  for (int i = 0; table.deviations && i < coefficientCount; ++i) text += "," + coefficientName(i) + "_sd";
  if (table.counts) text += ",n";
  text += table.largestDisplacement > 0.0 ? ",displacement\n" : "\n";
  for (int region = 0; region < DeformationTable::regionCount; ++region) {
    text += std::to_string(region + 1);
    for (int i = 0; i < coefficientCount; ++i)
      appendNumber(text += ",", table.maps[region].coefficients(i / 6, i % 6) + 0.0);  // no -0
    for (int i = 0; table.deviations && i < coefficientCount; ++i)
      appendNumber(text += ",", table.deviations->at(region)(i / 6, i % 6));
    if (table.counts) text += "," + std::to_string(table.counts->at(region));
    if (table.largestDisplacement > 0.0) appendNumber(text += ",", table.largestDisplacement);
    text += "\n";
  }
  return text;
}

}  // namespace mien
