#include "WarpMeshText.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "CommaText.h"
#include "LineReader.h"
#include "NumberText.h"

namespace mien {

namespace {

using Cells = std::vector<std::string>;

constexpr const char* key = "mien_warp_mesh";
constexpr double largestImage = 1e6;  // pixels along a side

std::string parseHead(const Cells& cells, WarpMesh& mesh) {
  if (cells[0] != key) return std::string("this is no warp mesh; its first line must be ") + key + ",1,WIDTH,HEIGHT";
  if (cells.size() < 2 || cells[1] != std::to_string(warpMeshVersion))
    return "this is a warp mesh of version " + inQuotes(cells.size() < 2 ? "" : cells[1]) +
           "; this program reads version " + std::to_string(warpMeshVersion);
  const auto size = [&](std::size_t i) { return i < cells.size() ? parseNumber(cells[i]).value_or(0.0) : 0.0; };
  mesh.width = size(2);
  mesh.height = size(3);
  const auto good = [](double side) { return side >= 1.0 && side <= largestImage; };
  if (!good(mesh.width) || !good(mesh.height))
    return "the size of the image is missing or no size; give WIDTH,HEIGHT in pixels";
  return {};
}

struct Point {
  double x = 0.0, y = 0.0;
  std::string name;
};

/// Points as they come; how large the mesh is shows at the end.
struct Points {
  std::size_t count = 0;
  int row = -1, column = -1, x = -1, y = -1, name = -1;
  std::map<std::pair<int, int>, Point> points;

  std::string setHeader(const Cells& header) {
    count = header.size();
    row = columnNamed(header, "row");
    column = columnNamed(header, "column");
    x = columnNamed(header, "x");
    y = columnNamed(header, "y");
    name = columnNamed(header, "name");
    return std::min({row, column, x, y}) < 0 ? "the second line must name the columns row, column, x and y" : "";
  }

  std::string add(const Cells& cells) {
    if (cells.size() != count)
      return "there are " + std::to_string(cells.size()) + " cells under " + std::to_string(count) + " columns";
    const auto i = index(cells[row]), j = index(cells[column]);
    if (!i || !j)
      return inQuotes(i ? cells[column] : cells[row]) + " is no " + (i ? "column" : "row") +
             " of a mesh; they count from 1 to " + std::to_string(WarpMesh::largestSide);
    const auto px = parseNumber(cells[x]), py = parseNumber(cells[y]);
    if (!px || !py) return inQuotes(px ? cells[y] : cells[x]) + " is no finite number; give pixels";
    if (!points.emplace(std::pair(*i, *j), Point{*px, *py, name < 0 ? "" : cells[name]}).second)
      return "the point in row " + cells[row] + ", column " + cells[column] + " is given twice; remove one of them";
    return {};
  }

  static std::optional<int> index(const std::string& text) {
    const auto value = parseWholeNumber(text);
    if (!value || *value < 1 || *value > WarpMesh::largestSide) return {};
    return static_cast<int>(*value);
  }

  std::string fill(WarpMesh& mesh) const {
    int rows = 0, columns = 0;
    for (const auto& [place, point] : points)
      rows = std::max(rows, place.first), columns = std::max(columns, place.second);
    WarpMesh filled(rows, columns, mesh.width, mesh.height);
    for (int i = 1; i <= rows; ++i)
      for (int j = 1; j <= columns; ++j) {
        const auto found = points.find({i, j});
        if (found == points.end())
          return "the point in row " + std::to_string(i) + ", column " + std::to_string(j) + " is missing; a mesh of " +
                 std::to_string(rows) + " x " + std::to_string(columns) + " has them all";
        filled.x(i - 1, j - 1) = found->second.x;
        filled.y(i - 1, j - 1) = found->second.y;
        if (name >= 0) filled.names.push_back(found->second.name);
      }
    mesh = std::move(filled);
    return describeFault(mesh, "the mesh");
  }
};

}  // namespace

std::string parseWarpMesh(const std::string& text, WarpMesh& mesh) {
  LineReader lines(text);
  WarpMesh parsed;
  Points points;
  std::string fault =
      lines.next() ? parseHead(splitAtCommas(lines.line()), parsed) : "the file is empty; give a warp mesh";
  if (fault.empty())
    fault = lines.next() ? points.setHeader(splitAtCommas(lines.line())) : "there are no points after this line";
  while (fault.empty() && lines.next()) fault = points.add(splitAtCommas(lines.line()));
  if (fault.empty()) fault = points.fill(parsed);
  if (!fault.empty()) return std::to_string(std::max(1, lines.number())) + ": " + fault;
  mesh = std::move(parsed);
  return {};
}

std::string writeWarpMesh(const WarpMesh& mesh) {
  const auto append = [](std::string& text, double number) { appendNumber(text += ",", number); };
  std::string text = std::string(key) + "," + std::to_string(warpMeshVersion);
  append(text, mesh.width);
  append(text, mesh.height);
  text += mesh.names.empty() ? "\nrow,column,x,y\n" : "\nrow,column,x,y,name\n";
  for (int i = 0; i < mesh.rows(); ++i)
    for (int j = 0; j < mesh.columns(); ++j) {
      text += std::to_string(i + 1) + "," + std::to_string(j + 1);
      append(text, mesh.x(i, j));
      append(text, mesh.y(i, j));
      if (!mesh.names.empty()) text += "," + mesh.names[static_cast<std::size_t>(i) * mesh.columns() + j];
      text += "\n";
    }
  return text;
}

}  // namespace mien
