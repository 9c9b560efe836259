#include "LandmarkTable.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>
#include <vector>

namespace mien {

namespace {

using Cells = std::vector<std::string>;

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r\"");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\"") - first + 1);
}

Cells splitCells(const std::string& line) {
  Cells cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(trimmed(cell));
  return cells;
}

/// Numbers are read in the C locale whatever the program's is.
bool parseNumber(const std::string& text, double& value) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  return (stream >> value) && stream.peek() == std::istringstream::traits_type::eof() && std::isfinite(value);
}

bool parseIndex(const std::string& text, long& value) {
  double number = 0.0;
  if (!parseNumber(text, number) || number < 0.0 || number > 1e9 || number != std::floor(number)) return false;
  value = static_cast<long>(number);
  return true;
}

/// Columns of the file by name; -1 for one that is not there.
struct Columns {
  int landmark = -1, vertex = -1;
  std::array<int, 3> position = {-1, -1, -1};

  explicit Columns(const Cells& header) {
    landmark = find(header, "landmark");
    vertex = find(header, "vertex");
    position = {find(header, "x"), find(header, "y"), find(header, "z")};
  }
  static int find(const Cells& header, const std::string& name) {
    const auto found = std::find(header.begin(), header.end(), name);
    return found == header.end() ? -1 : static_cast<int>(found - header.begin());
  }
  bool hasPosition() const { return *std::min_element(position.begin(), position.end()) >= 0; }
  bool complete() const { return landmark >= 0 && (vertex >= 0 || hasPosition()); }
};

std::string cellAt(const Cells& cells, int column) {
  return column >= 0 && column < static_cast<int>(cells.size()) ? cells[column] : std::string();
}

std::string parseRow(const Cells& cells, const Columns& columns, LandmarkTable& table, std::vector<bool>& seen) {
  long landmark = 0;
  if (!parseIndex(cellAt(cells, columns.landmark), landmark) || landmark >= FaceLandmarks::count)
    return "\"" + cellAt(cells, columns.landmark) + "\" is no landmark number; they run from 0 to 67";
  if (seen[landmark]) return "landmark " + std::to_string(landmark) + " is given twice; remove one of them";
  seen[landmark] = true;
  if (columns.vertex >= 0 && !parseIndex(cellAt(cells, columns.vertex), table.vertices[landmark]))
    return "\"" + cellAt(cells, columns.vertex) + "\" is no vertex number; give the index in the mesh, from 0";
  if (!columns.hasPosition()) return {};
  for (int i = 0; i < 3; ++i)
    if (!parseNumber(cellAt(cells, columns.position[i]), table.positions.points(landmark, i)))
      return "\"" + cellAt(cells, columns.position[i]) + "\" is no finite number; give x, y and z in mm";
  return {};
}

std::string missingLandmark(const std::vector<bool>& seen) {
  const auto missing = std::find(seen.begin(), seen.end(), false);
  if (missing == seen.end()) return {};
  return "landmark " + std::to_string(missing - seen.begin()) + " is missing; all 68 are needed";
}

}  // namespace

std::string parseLandmarks(const std::string& text, LandmarkTable& table) {
  std::istringstream stream(text);
  std::string line;
  std::getline(stream, line);
  const Columns columns(splitCells(line));
  if (!columns.complete()) return "1: the header must name the columns landmark and vertex, or landmark, x, y and z";
  LandmarkTable parsed;
  parsed.hasVertices = columns.vertex >= 0;
  std::vector<bool> seen(FaceLandmarks::count, false);
  int number = 1;
  while (std::getline(stream, line)) {
    ++number;
    if (trimmed(line).empty()) continue;
    const std::string fault = parseRow(splitCells(line), columns, parsed, seen);
    if (!fault.empty()) return std::to_string(number) + ": " + fault;
  }
  const std::string fault = missingLandmark(seen);
  if (!fault.empty()) return std::to_string(number) + ": " + fault;
  table = parsed;
  return {};
}

std::string placeLandmarks(const LandmarkTable& table, const TriangleMesh& mesh, FaceLandmarks& landmarks) {
  FaceLandmarks placed = table.positions;
  for (int i = 0; table.hasVertices && i < FaceLandmarks::count; ++i) {
    if (table.vertices[i] >= mesh.vertices.rows())
      return "landmark " + std::to_string(i) + " is vertex " + std::to_string(table.vertices[i]) + " of a mesh of " +
             std::to_string(mesh.vertices.rows()) + "; give landmarks made for this mesh, or positions without a vertex column";
    placed.points.row(i) = mesh.vertices.row(table.vertices[i]);
  }
  landmarks = placed;
  return {};
}

}  // namespace mien
