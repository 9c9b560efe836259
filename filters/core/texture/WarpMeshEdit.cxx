#include "WarpMeshEdit.h"

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

void place(WarpMesh& mesh, int row, int column, double x, double y) {
  mesh.x(row, column) = std::clamp(x, 0.0, mesh.width);
  mesh.y(row, column) = std::clamp(y, 0.0, mesh.height);
}

}  // namespace

MeshNode nearestNode(const WarpMesh& mesh, double x, double y, double reach) {
  MeshNode nearest;
  double least = reach;
  for (int i = 0; i < mesh.rows(); ++i)
    for (int j = 0; j < mesh.columns(); ++j) {
      const double distance = std::hypot(mesh.x(i, j) - x, mesh.y(i, j) - y);
      if (distance > least) continue;
      least = distance;
      nearest = {i, j};
    }
  return nearest;
}

std::string moveNode(WarpMesh& mesh, MeshNode node, double x, double y, bool mirrored) {
  const auto [row, column] = node;
  if (row < 0 || row >= mesh.rows() || column < 0 || column >= mesh.columns())
    return "the mesh has no point in row " + std::to_string(row + 1) + ", column " + std::to_string(column + 1);
  if (!std::isfinite(x) || !std::isfinite(y)) return "a point of the mesh cannot be placed at a place without numbers";
  WarpMesh moved = mesh;
  place(moved, row, column, x, y);
  const int other = mesh.columns() - 1 - column;
  if (mirrored && other != column)
    place(moved, row, other, mesh.x(row, other) - (moved.x(row, column) - mesh.x(row, column)),
          mesh.y(row, other) + (moved.y(row, column) - mesh.y(row, column)));
  const std::string fault = describeFault(moved, "the mesh");
  if (fault.empty()) mesh = std::move(moved);
  return fault;
}

}  // namespace mien
