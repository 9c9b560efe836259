#include "MarkerTable.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "CommaText.h"
#include "LineReader.h"
#include "NumberText.h"

namespace mien {

namespace {

using Cells = std::vector<std::string>;

const std::array<const char*, 6> positionNames = {"neutral_x",    "neutral_y",    "neutral_z",
                                                  "expression_x", "expression_y", "expression_z"};

struct MarkerColumns {
  std::size_t count = 0;
  int marker = -1, region = -1;
  std::array<int, 6> positions{};

  std::string find(const Cells& header) {
    count = header.size();
    marker = columnNamed(header, "marker");
    region = columnNamed(header, "region");
    for (std::size_t i = 0; i < 6; ++i) positions[i] = columnNamed(header, positionNames[i]);
    const bool plane = marker >= 0 && positions[0] >= 0 && positions[1] >= 0 && positions[3] >= 0 && positions[4] >= 0;
    if (!plane)
      return "the header must name marker, neutral_x, neutral_y, expression_x and expression_y" + separatorHint(header);
    if ((positions[2] < 0) != (positions[5] < 0)) return "give both neutral_z and expression_z, or neither";
    return {};
  }
  bool hasDepth() const { return positions[2] >= 0; }
};

using Seen = std::array<bool, 2>;  // neutral and expression

/// One row; `seen` is false in a state with blank cells.
std::string parseRow(const Cells& cells, const MarkerColumns& columns, const MarkerOptions& options, Marker& marker,
                     Seen& seen) {
  if (cells.size() != columns.count)
    return "there are " + std::to_string(cells.size()) + " cells under " + std::to_string(columns.count) +
           " columns; give one for each, blank where a marker was not seen";
  marker.name = cells[columns.marker];
  if (marker.name.empty()) return "the marker has no name; give one";
  seen = {true, true};
  for (int i = 0; i < 6; ++i) {
    if (columns.positions[i] < 0) continue;
    const std::string& cell = cells[columns.positions[i]];
    const std::optional<double> value = parseNumber(cell);
    if (!value && !cell.empty())
      return marker.name + ": " + inQuotes(cell) + " in column " + positionNames[i] + " is no finite number";
    if (!value) seen[i / 3] = false;
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

/// A pupil in both states: its line in the file of each, 0 where it has none.
struct PupilRow {
  std::array<Eigen::Vector3d, 2> places{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  std::array<int, 2> lines{};
  Seen seen{};
};

/// The rows of a file before the pupils are taken out.
struct MarkerRows {
  MarkerColumns columns;
  MarkerTable table;
  PupilRow left, right;
  int last = 1;

  std::string add(const Cells& cells, int line, const MarkerOptions& options) {
    Marker marker;
    marker.line = line;
    Seen seen{};
    const std::string fault = parseRow(cells, columns, options, marker, seen);
    if (!fault.empty()) return fault;
    if (!names.insert(marker.name).second) return marker.name + " is given twice; remove one of them";
    keep(marker, seen, {line, line}, options);
    return {};
  }

  void keep(const Marker& marker, const Seen& seen, const std::array<int, 2>& lines, const MarkerOptions& options) {
    if (marker.name == options.leftPupil || marker.name == options.rightPupil)
      (marker.name == options.leftPupil ? left : right) = {{marker.neutral, marker.expression}, lines, seen};
    else if (seen[0] && seen[1])
      table.markers.push_back(marker);
    else
      table.missing.push_back(marker.name);
  }

 private:
  std::set<std::string> names;
};

std::string at(int line, const std::string& fault) {
  return std::to_string(line) + ": " + fault;
}

/// Says where a fault of a state (0 neutral, 1 expression) is; line 0: in none.
using Where = std::function<std::string(int state, int line, const std::string& fault)>;

/// The pupils of one state: by place where the options say so, else those of the rows.
std::string setPupils(const MarkerRows& rows, int state, const MarkerOptions& options, const Where& where,
                      PupilNormalisation& normalisation) {
  if (const auto& places = state == 0 ? options.neutralPupils : options.expressionPupils) {
    const std::string fault = normalisation.set(options.upright(places->left), options.upright(places->right));
    return fault.empty() ? "" : where(state, 0, "the places given for the pupils do not serve: " + fault);
  }
  for (const auto& [pupil, name] : {std::pair(&rows.left, &options.leftPupil), {&rows.right, &options.rightPupil}})
    if (!pupil->seen[state])
      return where(state, std::max(pupil->lines[state], 1),
                   "the pupil " + *name + " is missing; every recording needs both pupils");
  const std::string fault = normalisation.set(rows.left.places[state], rows.right.places[state]);
  return fault.empty() ? "" : where(state, rows.left.lines[state], fault);
}

std::string normalise(MarkerRows& rows, const MarkerOptions& options, const Where& where) {
  MarkerTable& table = rows.table;
  std::string fault = setPupils(rows, 0, options, where, table.neutral);
  if (fault.empty()) fault = setPupils(rows, 1, options, where, table.expression);
  if (!fault.empty()) return fault;
  if (table.markers.empty()) return where(0, rows.last, "there is no marker besides the pupils");
  MarkerPlaces places;
  for (const Marker& marker : table.markers)
    places.emplace_back(marker.name, table.neutral.apply(marker.neutral).head<2>());
  const std::string posture = describePosture(places, true);
  return posture.empty() ? "" : where(0, options.neutralPupils ? 0 : rows.left.lines[0], posture);
}

}  // namespace

std::string MarkerTable::parse(const std::string& text, const MarkerOptions& options) {
  LineReader lines(text);
  MarkerRows rows;
  std::string fault = rows.columns.find(lines.next() ? splitAtCommas(lines.line()) : Cells());
  if (!fault.empty()) return at(std::max(lines.number(), 1), fault);
  while (lines.next()) {
    rows.last = lines.number();
    fault = rows.add(splitAtCommas(lines.line()), lines.number(), options);
    if (!fault.empty()) return at(lines.number(), fault);
  }
  rows.table.hasDepth = rows.columns.hasDepth();
  fault = normalise(rows, options, [](int state, int line, const std::string& what) {
    const char* const states[] = {"neutral: ", "expression: "};
    return (line ? std::to_string(line) + ": " : " ") + states[state] + what;
  });
  if (fault.empty()) *this = rows.table;
  return fault;
}

std::string MarkerTable::join(const PointTable& before, const PointTable& after, const MarkerOptions& options,
                              const std::array<std::string, 2>& names) {
  if (before.hasDepth != after.hasDepth)
    return names[0] + " and " + names[1] + ": one has a column z and the other none; give z in both or in neither";
  std::map<std::string, const NamedPoint*> moved;
  for (const NamedPoint& point : after.points) moved[point.name] = &point;
  MarkerRows rows;
  for (const NamedPoint& point : before.points) {
    const auto found = moved.find(point.name);
    const NamedPoint* other = found == moved.end() ? nullptr : found->second;
    Marker marker{point.name, point.line, point.region, point.position, Eigen::Vector3d::Zero()};
    if (other) marker.expression = other->position;
    rows.last = point.line;
    rows.keep(marker, {point.seen, other && other->seen}, {point.line, other ? other->line : 0}, options);
    moved.erase(point.name);
  }
  for (const auto& [name, point] : moved)
    rows.keep({name, 0, 0, {}, point->position}, {false, point->seen}, {0, point->line}, options);
  rows.table.hasDepth = before.hasDepth;
  const std::string fault = normalise(rows, options, [&](int state, int line, const std::string& what) {
    return names[state] + (line ? ":" + std::to_string(line) : std::string()) + ": " + what;
  });
  if (fault.empty()) *this = rows.table;
  return fault;
}

}  // namespace mien
