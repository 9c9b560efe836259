#include "TableInput.h"

#include <filesystem>
#include <iostream>
#include <sstream>

#include "CommaText.h"
#include "Failure.h"
#include "NamedTables.h"
#include "OutputFile.h"
#include "TableList.h"

namespace mien {

namespace {

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
  std::error_code ignored;
  if (!namedTable(nameOrFile) && fileEnding(nameOrFile) == "csv" &&
      std::filesystem::is_regular_file(nameOrFile, ignored) && isRecording(readMarkerText(nameOrFile)))
    throw FileFailure(nameOrFile +
                      ": this is a recording of markers, and a table is wanted; make one with mien fdt fit " +
                      nameOrFile + " -o table.csv");
  const std::string fault = readNamedTable(nameOrFile, table);
  if (!fault.empty()) throw FileFailure(fault);
  return table;
}

DeformationTable readWeightedTables(const std::vector<std::string>& texts) {
  std::vector<std::pair<DeformationTable, double>> tables;
  std::error_code ignored;
  for (const std::string& text : texts) {
    std::vector<WeightedName> parts;
    const std::string fault =
        namedTable(text) || std::filesystem::is_regular_file(text, ignored) ? "" : parseTableList(text, parts);
    if (!fault.empty()) throw ValueFailure(fault);
    if (parts.empty()) parts.push_back({text, 1.0});
    for (const WeightedName& part : parts) tables.emplace_back(readTable(part.name), part.weight);
  }
  return DeformationTable::weighted(tables);
}

TableInput readTableOrRecording(const std::string& nameOrFile, const MarkerFileOptions& options,
                                const FacialRegions& regions) {
  TableInput input;
  input.name = nameOrFile;
  std::error_code ignored;
  const bool isFile = !namedTable(nameOrFile) && std::filesystem::is_regular_file(nameOrFile, ignored);
  const std::string text = isFile ? readMarkerText(nameOrFile) : std::string();
  if (!isRecording(text)) {
    input.table = readTable(nameOrFile);
    return input;
  }
  input.markers = parseRecording(text, nameOrFile, options);
  const FittedTable fitted = fitMarkers(*input.markers, regions, false, nameOrFile);
  if (!fitted.warning.empty()) std::cerr << "mien: " << nameOrFile << ": " << fitted.warning << "\n";
  input.table = fitted.table;
  input.rms = fitted.rms;
  return input;
}

std::string describeUnknown(const DeformationTable& table) {
  const std::vector<int> unknown = table.unknownRegions();
  std::string text = unknown.size() == 1 ? "region " : "regions ";
  for (std::size_t i = 0; i < unknown.size(); ++i) text += (i ? ", " : "") + std::to_string(unknown[i]);
  return unknown.empty() ? "" : text + (unknown.size() == 1 ? " is" : " are") + " not known (no markers): still";
}

std::string shortTableName(const std::string& nameOrFile) {
  return namedTable(nameOrFile) ? nameOrFile : std::filesystem::path(nameOrFile).stem().string();
}

}  // namespace mien
