#include "TableInfo.h"

#include <filesystem>
#include <sstream>

#include "CommaText.h"
#include "DefaultRegions.h"
#include "InfoText.h"
#include "MarkerFileOptions.h"
#include "OutputFile.h"
#include "TableDeformation.h"
#include "TableInput.h"
#include "TableRows.h"

namespace mien {

namespace {

using json = nlohmann::ordered_json;

/// The columns of a .csv file, from its first line that is no comment.
std::vector<std::string> headerOf(const std::string& text) {
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("\xEF\xBB\xBF", 0) == 0) line.erase(0, 3);
    if (!line.empty() && line[0] != '#' && line != "\r") return splitAtCommas(line);
  }
  return {};
}

json describeTable(const std::string& name) {
  const DeformationTable table = readTable(name);
  json about = {{"kind", fileEnding(name) == "fdt" ? "packed facial deformation table" : "facial deformation table"},
                {"file", name},
                {"regions", DeformationTable::regionCount},
                {"regions_not_known", table.unknownRegions()},
                {"deviations", table.deviations.has_value()},
                {"largest_displacement", fittedDisplacement(table, defaultRegions())}};
  if (table.counts) about["n"] = *table.counts;
  return about;
}

/// A recording is read as mien fdt fit does without options; what keeps it from being fitted is told, not an error.
json describeRecording(const std::string& name, const std::string& text, bool both) {
  json about = {{"kind", both ? "recording of markers before and after" : "markers of one state"}, {"file", name}};
  PointTable points;
  MarkerTable markers;
  const std::string fault = both ? markers.parse(text) : points.parse(text);
  if (!fault.empty()) {
    about["fault"] = fault;
    return about;
  }
  about["markers"] = both ? markers.markers.size() : points.points.size();
  if (both) about["missing"] = markers.missing;
  about["depth"] = both ? markers.hasDepth : points.hasDepth;
  return about;
}

std::string listed(const json& values) {
  std::string text;
  for (const json& value : values)
    text += (text.empty() ? "" : ", ") + (value.is_string() ? std::string(value) : value.dump());
  return text.empty() ? "none" : text;
}

}  // namespace

json describeTableFile(const std::string& name) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(name, ignored)) return nullptr;
  if (fileEnding(name) == "fdt") return describeTable(name);
  if (fileEnding(name) != "csv") return nullptr;
  const std::string text = readMarkerText(name);
  const std::vector<std::string> header = headerOf(text);
  const auto has = [&](const char* column) { return columnNamed(header, column) >= 0; };
  if (has("region") && has("a1") && has("b6")) return describeTable(name);
  if (has("marker") && has("neutral_x")) return describeRecording(name, text, true);
  return has("marker") && has("x") ? describeRecording(name, text, false) : json(nullptr);
}

void printTableFile(const json& about) {
  for (const auto& entry : about.items()) {
    const json& value = entry.value();
    printLine(entry.key(), value.is_array()          ? listed(value)
                           : value.is_string()       ? std::string(value)
                           : value.is_boolean()      ? (value ? "yes" : "no")
                           : value.is_number_float() ? readableNumber(value) + " pupil units"
                                                     : value.dump());
  }
}

}  // namespace mien
