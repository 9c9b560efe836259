#include "LandmarkTable.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "CommaText.h"
#include "LineReader.h"
#include "NumberText.h"
#include "SmoothWarp.h"

namespace mien {

namespace {

using Cells = std::vector<std::string>;

/// What the pose, the unit and the curves need most.
constexpr std::array<std::pair<int, const char*>, 12> names = {{{8, "chin"},
                                                                {27, "nose_bridge"},
                                                                {30, "nose_tip"},
                                                                {33, "nose_base"},
                                                                {36, "right_eye_outer"},
                                                                {39, "right_eye_inner"},
                                                                {42, "left_eye_inner"},
                                                                {45, "left_eye_outer"},
                                                                {48, "right_mouth_corner"},
                                                                {51, "upper_lip"},
                                                                {54, "left_mouth_corner"},
                                                                {57, "lower_lip"}}};

/// Columns of the file by name; -1 for one that is not there.
struct LandmarkColumns {
  std::size_t count;
  int landmark, vertex;
  std::array<int, 3> position;

  explicit LandmarkColumns(const Cells& header)
      : count(header.size()),
        landmark(columnNamed(header, "landmark")),
        vertex(columnNamed(header, "vertex")),
        position{columnNamed(header, "x"), columnNamed(header, "y"), columnNamed(header, "z")} {}
  bool hasPlane() const { return position[0] >= 0 && position[1] >= 0; }
  bool hasPosition() const { return hasPlane() && position[2] >= 0; }
};

std::string cellAt(const Cells& cells, int column) {
  return column >= 0 && column < static_cast<int>(cells.size()) ? cells[column] : std::string();
}

std::string withName(int landmark) {
  const std::string name = landmarkName(landmark);
  return "landmark " + std::to_string(landmark) + (name.empty() ? "" : " (" + name + ")");
}

/// A number or a name; -1 when it is neither.
int parseLandmark(const std::string& text) {
  for (const auto& [number, name] : names)
    if (text == name) return number;
  const auto number = parseWholeNumber(text);
  return number && *number >= 0 && *number < FaceLandmarks::count ? static_cast<int>(*number) : -1;
}

/// Reads the lines below the header into a table.
class RowReader {
 public:
  RowReader(const LandmarkColumns& columns, LandmarkTable& table) : columns_(columns), table_(table) {}

  std::string read(const Cells& cells) {
    if (cells.size() != columns_.count)
      return "there are " + std::to_string(cells.size()) + " cells under " + std::to_string(columns_.count) +
             " columns";
    const std::string given = columns_.landmark >= 0 ? cellAt(cells, columns_.landmark) : std::to_string(next_++);
    const int landmark = parseLandmark(given);
    if (landmark < 0) return inQuotes(given) + " is no landmark number or name; numbers run from 0 to 67";
    if (table_.given[landmark]) return "landmark " + std::to_string(landmark) + " is given twice; remove one of them";
    table_.given[landmark] = true;
    const std::string fault = table_.hasVertices ? readVertex(cells, landmark) : std::string();
    return fault.empty() ? readPosition(cells, landmark) : fault;
  }

 private:
  std::string readVertex(const Cells& cells, int landmark) {
    constexpr std::int64_t largest = 1000000000;
    const std::string cell = cellAt(cells, columns_.vertex);
    const auto vertex = parseWholeNumber(cell);
    if (!vertex || *vertex < 0 || *vertex > largest)
      return inQuotes(cell) + " is no vertex number; give the index in the mesh, from 0";
    table_.vertices[landmark] = static_cast<long>(*vertex);
    return {};
  }

  std::string readPosition(const Cells& cells, int landmark) {
    for (int i = 0; i < 3; ++i) {
      if (columns_.position[i] < 0 || (table_.hasVertices && !columns_.hasPosition())) continue;
      const std::string cell = cellAt(cells, columns_.position[i]);
      const auto number = parseNumber(cell);
      if (!number) return inQuotes(cell) + " is no finite number; give the place in the scan's unit, or in pixels";
      table_.positions.points(landmark, i) = *number;
    }
    return {};
  }

  const LandmarkColumns& columns_;
  LandmarkTable& table_;
  int next_ = 0;
};

/// Without numbers rows count from 0, which is right only where no other column can be meant.
std::string describeUnnumbered(const Cells& header) {
  if (columnNamed(header, "landmark") >= 0) return {};
  for (const std::string& name : header)
    if (name != "vertex" && name != "x" && name != "y" && name != "z")
      return "there is no column landmark, but " + inQuotes(name) +
             "; call the column of the numbers landmark, or leave it out where rows run from landmark 0 to 67";
  return {};
}

/// The columns of a list of landmarks on a picture that begins without a header: x and y, or number, x and y. Nothing
/// of any other first line.
Cells impliedColumns(const Cells& first) {
  const bool numbered = first.size() == 3;
  if (!numbered && first.size() != 2) return {};
  for (std::size_t i = 0; i < first.size(); ++i)
    if (!parseNumber(first[i]) && !(numbered && i == 0 && parseLandmark(first[i]) >= 0)) return {};
  return numbered ? Cells{"landmark", "x", "y"} : Cells{"x", "y"};
}

/// All lines of a file whose header was judged by `accepts`.
/// @param implied  the columns of a file without header, from its first line; none: that line is the header
template <class Accepts>
std::string parseRows(
    const std::string& text, LandmarkTable& table, int& lines, Accepts accepts,
    Cells (*implied)(const Cells&) = [](const Cells&) { return Cells(); }) {
  LineReader file(text);
  file.next();
  const Cells first = splitAtCommas(file.line()), without = implied(first);
  const Cells& header = without.empty() ? first : without;
  const LandmarkColumns columns(header);
  std::string fault = accepts(columns);
  if (fault.empty()) fault = describeUnnumbered(header);
  table.hasVertices = columns.vertex >= 0;
  RowReader reader(columns, table);
  if (fault.empty() && !without.empty()) fault = reader.read(first);
  while (fault.empty() && file.next()) fault = reader.read(splitAtCommas(file.line()));
  lines = std::max(1, file.number());
  return fault.empty() ? fault : std::to_string(lines) + ": " + fault;
}

std::string missingLandmark(const LandmarkTable::Given& given, bool onlyNamed) {
  for (int i = 0; i < FaceLandmarks::count; ++i)
    if (!given[i] && !(onlyNamed && landmarkName(i).empty()))
      return withName(i) + " is missing; " +
             (onlyNamed ? "the twelve landmarks with names are needed, see mien acquire --help" : "all 68 are needed");
  return {};
}

}  // namespace

std::string landmarkName(int landmark) {
  for (const auto& [number, name] : names)
    if (number == landmark) return name;
  return {};
}

std::string parseLandmarks(const std::string& text, LandmarkTable& table) {
  LandmarkTable parsed;
  int lines = 0;
  std::string fault = parseRows(text, parsed, lines, [](const LandmarkColumns& columns) {
    return columns.vertex >= 0 || columns.hasPosition()
               ? std::string()
               : "the header must name the columns landmark and vertex, or landmark, x, y and z";
  });
  if (!fault.empty()) return fault;
  fault = missingLandmark(parsed.given, true);
  if (!fault.empty()) return std::to_string(lines) + ": " + fault;
  table = parsed;
  return {};
}

std::string parsePictureLandmarks(const std::string& text, FaceLandmarks& landmarks) {
  LandmarkTable parsed;
  int lines = 0;
  const auto accepts = [](const LandmarkColumns& columns) {
    return columns.hasPlane() ? std::string()
                              : "the header must name the columns landmark, x and y; without a header the rows are "
                                "landmark,x,y, or x,y in the order of the landmarks";
  };
  std::string fault = parseRows(text, parsed, lines, accepts, impliedColumns);
  if (!fault.empty()) return fault;
  fault = missingLandmark(parsed.given, false);
  if (!fault.empty()) return std::to_string(lines) + ": " + fault;
  parsed.positions.points.col(2).setZero();
  landmarks = parsed.positions;
  return {};
}

std::string placeLandmarks(const LandmarkTable& table, const TriangleMesh& mesh, FaceLandmarks& landmarks) {
  FaceLandmarks placed = table.positions;
  for (int i = 0; table.hasVertices && i < FaceLandmarks::count; ++i) {
    if (!table.given[i]) continue;
    if (table.vertices[i] >= mesh.vertices.rows())
      return "landmark " + std::to_string(i) + " is vertex " + std::to_string(table.vertices[i]) + " of a mesh of " +
             std::to_string(mesh.vertices.rows()) +
             "; give landmarks made for this mesh, or positions without a vertex column";
    placed.points.row(i) = mesh.vertices.row(table.vertices[i]);
  }
  landmarks = placed;
  return {};
}

std::string completeLandmarks(const FaceLandmarks& reference, const LandmarkTable::Given& given,
                              FaceLandmarks& landmarks) {
  const auto count = static_cast<Eigen::Index>(std::count(given.begin(), given.end(), true));
  if (count == FaceLandmarks::count) return {};
  SmoothWarp::Points from(count, 3), to(count, 3);
  for (int i = 0, row = 0; i < FaceLandmarks::count; ++i) {
    if (!given[i]) continue;
    from.row(row) = reference.points.row(i);
    to.row(row++) = landmarks.points.row(i);
  }
  const SmoothWarp warp(from, to);
  if (!warp.sound()) return "the other landmarks cannot be placed from those that are given; give all 68";
  for (int i = 0; i < FaceLandmarks::count; ++i)
    if (!given[i]) landmarks.points.row(i) = warp(reference[i]).transpose();
  return {};
}

std::string landmarkText(const FaceLandmarks& landmarks) {
  std::string text = "landmark,x,y,z\n";
  for (int i = 0; i < FaceLandmarks::count; ++i) {
    text += std::to_string(i);
    for (int k = 0; k < 3; ++k) {
      text += ",";
      appendNumber(text, landmarks.points(i, k));
    }
    text += "\n";
  }
  return text;
}

}  // namespace mien
