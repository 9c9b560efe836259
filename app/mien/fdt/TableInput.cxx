#include "TableInput.h"

#include <cmath>
#include <filesystem>
#include <iostream>
#include <sstream>

#include "Arguments.h"
#include "CommaText.h"
#include "Failure.h"
#include "NamedTables.h"

namespace mien {

namespace {

constexpr double largestWeight = 10.0;

/// Whether the first line that is no comment names the column `marker`.
bool isRecording(const std::string& text) {
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("\xEF\xBB\xBF", 0) == 0) line.erase(0, 3);
    if (line.empty() || line[0] == '#' || line == "\r") continue;
    return columnNamed(splitAtCommas(line), "marker") >= 0;
  }
  return false;
}

}  // namespace

DeformationTable readTable(const std::string& nameOrFile) {
  DeformationTable table;
  const std::string fault = readNamedTable(nameOrFile, table);
  if (!fault.empty()) throw FileFailure(fault);
  return table;
}

DeformationTable readWeightedTables(const std::vector<std::string>& texts) {
  std::vector<std::pair<DeformationTable, double>> tables;
  for (const std::string& text : texts) {
    const auto [name, weight] = parseWeighted("the weight of", text);
    if (!(std::abs(weight) <= largestWeight))
      throw ValueFailure("the weight in '" + text + "' is outside -10 .. 10; 1 is the table as it is");
    tables.emplace_back(readTable(name), weight);
  }
  return DeformationTable::weighted(tables);
}

TableInput readTableOrRecording(const std::string& nameOrFile, const MarkerFileOptions& options,
                                const FacialRegions& regions) {
  TableInput input;
  input.name = nameOrFile;
  std::error_code ignored;
  if (namedTable(nameOrFile) || !std::filesystem::is_regular_file(nameOrFile, ignored) ||
      !isRecording(readMarkerText(nameOrFile))) {
    input.table = readTable(nameOrFile);
    return input;
  }
  input.markers = readRecording(nameOrFile, options);
  const FittedTable fitted = fitMarkers(*input.markers, regions, false, nameOrFile);
  if (!fitted.warning.empty()) std::cerr << "mien: " << nameOrFile << ": " << fitted.warning << "\n";
  input.table = fitted.table;
  input.rms = fitted.rms;
  return input;
}

std::string shortTableName(const std::string& nameOrFile) {
  return namedTable(nameOrFile) ? nameOrFile : std::filesystem::path(nameOrFile).stem().string();
}

}  // namespace mien
