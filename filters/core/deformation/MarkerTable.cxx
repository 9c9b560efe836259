#include "MarkerTable.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <sstream>

#include "CommaText.h"
#include "NumberText.h"

namespace mien {

namespace {

using Cells = std::vector<std::string>;

const std::array<const char*, 6> positionNames = {"neutral_x",    "neutral_y",    "neutral_z",
                                                  "expression_x", "expression_y", "expression_z"};

struct Columns {
  std::size_t count = 0;
  int marker = -1, region = -1;
  std::array<int, 6> positions{};

  std::string find(const Cells& header) {
    count = header.size();
    marker = columnNamed(header, "marker");
    region = columnNamed(header, "region");
    for (std::size_t i = 0; i < 6; ++i) positions[i] = columnNamed(header, positionNames[i]);
    const bool plane = marker >= 0 && positions[0] >= 0 && positions[1] >= 0 && positions[3] >= 0 && positions[4] >= 0;
    if (!plane) return "the header must name marker, neutral_x, neutral_y, expression_x and expression_y";
    if ((positions[2] < 0) != (positions[5] < 0)) return "give both neutral_z and expression_z, or neither";
    return {};
  }
  bool hasDepth() const { return positions[2] >= 0; }
};

/// One row; `seen` is false for a marker with blank cells.
std::string parseRow(const Cells& cells, const Columns& columns, const MarkerOptions& options, Marker& marker,
                     bool& seen) {
  if (cells.size() != columns.count)
    return "there are " + std::to_string(cells.size()) + " cells under " + std::to_string(columns.count) +
           " columns; give one for each, blank where a marker was not seen";
  marker.name = cells[columns.marker];
  if (marker.name.empty()) return "the marker has no name; give one";
  seen = true;
  for (int i = 0; i < 6; ++i) {
    if (columns.positions[i] < 0) continue;
    const std::string& cell = cells[columns.positions[i]];
    const std::optional<double> value = parseNumber(cell);
    if (!value && !cell.empty())
      return marker.name + ": " + inQuotes(cell) + " in column " + positionNames[i] + " is no finite number";
    seen = seen && value;
    (i < 3 ? marker.neutral : marker.expression)[i % 3] = value.value_or(0.0);
  }
  marker.neutral = options.upright(marker.neutral);
  marker.expression = options.upright(marker.expression);
  const std::string region = columns.region < 0 ? "" : cells[columns.region];
  const std::optional<int> number = parseRegion(region);
  if (!number)
    return marker.name + ": " + inQuotes(region) + " is no region; regions run from 1 to 16, blank for by place";
  marker.region = *number;
  return {};
}

/// The rows of a file before the pupils are taken out.
struct Rows {
  Columns columns;
  MarkerTable table;
  Marker left, right;
  int last = 1;

  std::string add(const Cells& cells, int line, const MarkerOptions& options) {
    Marker marker;
    marker.line = line;
    bool seen = false;
    const std::string fault = parseRow(cells, columns, options, marker, seen);
    if (!fault.empty()) return fault;
    if (!names.insert(marker.name).second) return marker.name + " is given twice; remove one of them";
    keep(marker, seen, options);
    return {};
  }

  void keep(const Marker& marker, bool seen, const MarkerOptions& options) {
    if (!seen)
      table.missing.push_back(marker.name);
    else if (marker.name == options.leftPupil)
      left = marker;
    else if (marker.name == options.rightPupil)
      right = marker;
    else
      table.markers.push_back(marker);
  }

 private:
  std::set<std::string> names;
};

std::string at(int line, const std::string& fault) {
  return std::to_string(line) + ": " + fault;
}

/// The pupils of one state: by place where the options say so, else those of the rows.
EyePupils pupilsOf(const std::optional<EyePupils>& places, const EyePupils& rows, const MarkerOptions& options) {
  return places ? EyePupils{options.upright(places->left), options.upright(places->right)} : rows;
}

std::string describeMissingPupil(const Rows& rows, const MarkerOptions& options) {
  if (options.neutralPupils && options.expressionPupils) return {};
  for (const auto& [pupil, name] : {std::pair(&rows.left, &options.leftPupil), {&rows.right, &options.rightPupil}})
    if (!pupil->line) return "the pupil " + *name + " is missing; every recording needs both pupils";
  return {};
}

std::string normalise(Rows& rows, const MarkerOptions& options) {
  const std::string missing = describeMissingPupil(rows, options);
  if (!missing.empty()) return at(rows.last, missing);
  MarkerTable& table = rows.table;
  const int line = std::max(rows.left.line, 1);
  const EyePupils before = pupilsOf(options.neutralPupils, {rows.left.neutral, rows.right.neutral}, options);
  const EyePupils after = pupilsOf(options.expressionPupils, {rows.left.expression, rows.right.expression}, options);
  const std::string neutral = table.neutral.set(before.left, before.right);
  if (!neutral.empty()) return at(line, "neutral: " + neutral);
  const std::string expression = table.expression.set(after.left, after.right);
  if (!expression.empty()) return at(line, "expression: " + expression);
  if (table.markers.empty()) return at(rows.last, "there is no marker besides the pupils");
  std::vector<std::pair<std::string, double>> heights;
  for (const Marker& marker : table.markers) heights.emplace_back(marker.name, table.neutral.apply(marker.neutral).y());
  const std::string posture = describePosture(heights);
  return posture.empty() ? "" : at(line, posture);
}

}  // namespace

std::string MarkerTable::parse(const std::string& text, const MarkerOptions& options) {
  std::istringstream stream(text);
  std::string line;
  std::getline(stream, line);
  if (line.rfind("\xEF\xBB\xBF", 0) == 0) line.erase(0, 3);
  Rows rows;
  std::string fault = rows.columns.find(splitAtCommas(line));
  if (!fault.empty()) return at(1, fault);
  for (int number = 2; std::getline(stream, line); ++number) {
    if (line.find_first_not_of(" \t\r,") == std::string::npos) continue;
    rows.last = number;
    fault = rows.add(splitAtCommas(line), number, options);
    if (!fault.empty()) return at(number, fault);
  }
  rows.table.hasDepth = rows.columns.hasDepth();
  fault = normalise(rows, options);
  if (fault.empty()) *this = rows.table;
  return fault;
}

std::string MarkerTable::join(const PointTable& before, const PointTable& after, const MarkerOptions& options) {
  if (before.hasDepth != after.hasDepth)
    return "one file has a column z and the other none; give z in both or in neither";
  std::map<std::string, const NamedPoint*> moved;
  for (const NamedPoint& point : after.points) moved[point.name] = &point;
  Rows rows;
  for (const NamedPoint& point : before.points) {
    const auto found = moved.find(point.name);
    const bool seen = found != moved.end() && point.seen && found->second->seen;
    Marker marker{point.name, point.line, point.region, point.position, {}};
    if (seen) marker.expression = found->second->position;
    rows.last = point.line;
    rows.keep(marker, seen, options);
    moved.erase(point.name);
  }
  for (const auto& [name, point] : moved) rows.table.missing.push_back(name);
  rows.table.hasDepth = before.hasDepth;
  const std::string fault = normalise(rows, options);
  if (fault.empty()) *this = rows.table;
  return fault;
}

}  // namespace mien
