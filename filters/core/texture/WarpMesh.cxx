#include "WarpMesh.h"

#include <cmath>

namespace mien {

namespace {

std::string pairFrom(int first) {
  return std::to_string(first) + " and " + std::to_string(first + 1);
}

std::string describeSides(const WarpMesh& mesh, const std::string& name) {
  const auto good = [](int n) { return n >= 2 && n <= WarpMesh::largestSide; };
  if (!good(mesh.rows()) || !good(mesh.columns()))
    return name + " has " + std::to_string(mesh.rows()) + " x " + std::to_string(mesh.columns()) + " points; 2 to " +
           std::to_string(WarpMesh::largestSide) + " rows and columns are allowed";
  if (!(mesh.width >= 1.0 && mesh.height >= 1.0) || !std::isfinite(mesh.width + mesh.height))
    return name + " does not say the size of its image";
  return {};
}

/// Counted from 1 for people, as in the file.
std::string describeFold(const WarpMesh& mesh, const std::string& name) {
  for (int i = 0; i < mesh.rows(); ++i)
    for (int j = 0; j < mesh.columns(); ++j) {
      if (j > 0 && !(mesh.x(i, j) > mesh.x(i, j - 1)))
        return name + " is folded: columns " + pairFrom(j) + " cross in row " + std::to_string(i + 1) +
               "; x must grow from left to right";
      if (i > 0 && !(mesh.y(i, j) > mesh.y(i - 1, j)))
        return name + " is folded: rows " + pairFrom(i) + " cross in column " + std::to_string(j + 1) +
               "; y must grow from top to bottom";
    }
  return {};
}

}  // namespace

WarpMesh::WarpMesh(int rows, int columns, double imageWidth, double imageHeight)
    : width(imageWidth),
      height(imageHeight),
      x(Coordinates::Zero(rows, columns)),
      y(Coordinates::Zero(rows, columns)) {}

bool WarpMesh::operator==(const WarpMesh& other) const {
  return rows() == other.rows() && columns() == other.columns() && width == other.width && height == other.height &&
         x == other.x && y == other.y && names == other.names;
}

WarpMesh evenMesh(int rows, int columns, double width, double height) {
  WarpMesh mesh(rows, columns, width, height);
  mesh.x.rowwise() = Eigen::RowVectorXd::LinSpaced(columns, 0.0, width);
  mesh.y.colwise() = Eigen::VectorXd::LinSpaced(rows, 0.0, height);
  return mesh;
}

WarpMesh scaledMesh(const WarpMesh& mesh, double width, double height) {
  WarpMesh scaled = mesh;
  if (width == mesh.width && height == mesh.height) return scaled;
  scaled.x *= width / mesh.width;
  scaled.y *= height / mesh.height;
  scaled.width = width;
  scaled.height = height;
  return scaled;
}

std::string describeFault(const WarpMesh& mesh, const std::string& name) {
  const std::string fault = describeSides(mesh, name);
  if (!fault.empty()) return fault;
  if (!mesh.x.allFinite() || !mesh.y.allFinite()) return name + " has a point that is not finite";
  return describeFold(mesh, name);
}

}  // namespace mien
