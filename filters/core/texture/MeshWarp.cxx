#include "MeshWarp.h"

#include <utility>

#include "MonotoneWalk.h"
#include "SmoothStep.h"

namespace mien {

namespace {

using Knots = WarpMesh::Coordinates;

/// The splines through the columns of a mesh, read at the middle of every pixel of a line of `count` pixels.
Knots crossings(const Knots& along, const Knots& across, int count) {
  const int splines = static_cast<int>(along.cols());
  Knots result(count, splines);
  for (int j = 0; j < splines; ++j)
    MonotoneWalk(along.data() + j, across.data() + j, static_cast<int>(along.rows()), splines)
        .follow(0.5, count, result.data() + j, splines);
  return result;
}

MonotoneWalk walk(const Knots& from, const Knots& to, int line) {
  return {from.row(line).data(), to.row(line).data(), static_cast<int>(from.cols())};
}

struct Words {
  const char* line;  ///< "columns" or "rows"
  const char* axis;  ///< along which the pixels lie that cross them
};

/// Between the points of a mesh its splines may still cross.
std::string describeCrossing(const Knots& knots, const std::string& name, const Words& words) {
  for (Eigen::Index i = 0; i < knots.rows(); ++i)
    for (Eigen::Index j = 1; j < knots.cols(); ++j)
      if (!(knots(i, j) > knots(i, j - 1)))
        return name + " is folded: " + words.line + " " + std::to_string(j) + " and " + std::to_string(j + 1) +
               " cross at " + words.axis + " = " + std::to_string(i) + " pixels";
  return {};
}

}  // namespace

std::string MeshWarp::set(const WarpMesh& source, const WarpMesh& target, ImageSize sourceSize, ImageSize warpedSize,
                          bool closed) {
  for (const auto& [mesh, name] : {std::pair(&source, "the source mesh"), std::pair(&target, "the target mesh")}) {
    const std::string fault = describeFault(*mesh, name);
    if (!fault.empty()) return fault;
  }
  if (source.rows() != target.rows() || source.columns() != target.columns())
    return "the source mesh has " + std::to_string(source.rows()) + " x " + std::to_string(source.columns()) +
           " points and the target mesh " + std::to_string(target.rows()) + " x " + std::to_string(target.columns()) +
           "; give two of the same size";
  const WarpMesh from = scaledMesh(source, sourceSize.width, sourceSize.height);
  const WarpMesh to = scaledMesh(target, warpedSize.width, warpedSize.height);
  sourceSize_ = sourceSize;
  warpedSize_ = warpedSize;
  rowSource_ = crossings(from.y, from.x, sourceSize.height);
  rowTarget_ = crossings(from.y, to.x, sourceSize.height);
  columnSource_ = crossings(to.x.transpose(), from.y.transpose(), warpedSize.width);
  columnTarget_ = crossings(to.x.transpose(), to.y.transpose(), warpedSize.width);
  if (closed) close(from, to);
  for (const std::string& fault : {describeCrossing(rowSource_, "the source mesh", {"columns", "y"}),
                                   describeCrossing(rowTarget_, "the target mesh", {"columns", "y"}),
                                   describeCrossing(columnSource_, "the source mesh", {"rows", "x"}),
                                   describeCrossing(columnTarget_, "the target mesh", {"rows", "x"})})
    if (!fault.empty()) return fault;
  return {};
}

void MeshWarp::close(const WarpMesh& from, const WarpMesh& to) {
  const int last = to.columns() - 1;
  for (int i = 0; i < to.rows(); ++i) {
    const double left = to.x(i, 0), right = to.x(i, last);
    for (int column = 0; column < warpedSize_.width; ++column) {
      const double share = smoothStep(wayAround(column + 0.5, left, right, warpedSize_.width));
      if (share == 0.0) continue;
      columnSource_(column, i) = from.y(i, last) + share * (from.y(i, 0) - from.y(i, last));
      columnTarget_(column, i) = to.y(i, last) + share * (to.y(i, 0) - to.y(i, last));
    }
  }
}

void MeshWarp::rowBorders(int row, int first, int count, double* x) const {
  walk(rowTarget_, rowSource_, row).follow(first, count, x);
}

void MeshWarp::columnBorders(int column, int first, int count, double* y) const {
  walk(columnTarget_, columnSource_, column).follow(first, count, y);
}

}  // namespace mien
