#include "FaceSample.h"

#include <Eigen/Geometry>

namespace mien {

namespace {

/// Orders in u and v of the derivatives of a jet.
constexpr int orders[6][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}};

Eigen::VectorXd columnParameters(int columns) {
  return Eigen::VectorXd::LinSpaced(columns + 1, 0.0, 2.0 * M_PI).head(columns);
}

/// u of the rows of a patch, both seams among them.
std::vector<double> rowsOfPatch(const RowLayout& layout, int patch) {
  std::vector<double> u = {0.0};
  for (const FaceRow& row : layout.rows())
    if (row.patch == patch && row.u > 0.0) u.push_back(row.u);
  if (u.back() < 1.0) u.push_back(1.0);
  return u;
}

}  // namespace

FaceSample::FaceSample(const FaceCurves& face, const FaceSurfaceOptions& options, int rows, int columns)
    : columns_(columns), mouth_(face) {
  dealRows(rows);
  std::vector<SurfacePiece> pieces = facePieces(options, RowLayout(rows, false));
  dealRowsTo(pieces);
  const HarmonicSplit split(face.curves.pointsPerCurve, options.modes, options.remainder);
  PDESurface<double> surface(pieces, split, FaceLayout::curveCount, columnParameters(columns), 2);
  fault_ = surface.fault();
  if (!fault_.empty()) return;
  surface.setCurves(face.curves);
  for (size_t i = 0; i < grids_.size(); ++i) {
    grids_[i].resize(rowCount(), 3 * columns);
    surface.evaluate(orders[i][0], orders[i][1], 0,
                     PDESurface<double>::Grid(grids_[i].data(), rowCount(), 3 * columns));
  }
}

FaceSample::FaceSample(const std::function<SurfaceJet(int, double, double)>& surface, int rows, int columns,
                       const MouthCorners& mouth)
    : columns_(columns), mouth_(mouth) {
  dealRows(rows);
  for (RowMajor<double>& grid : grids_) grid.resize(rowCount(), 3 * columns);
  for (int patch = 0; patch < FaceLayout::patchCount; ++patch)
    for (int row = firstRow(patch); row < firstRow(patch + 1); ++row)
      for (int column = 0; column < columns; ++column) {
        const SurfaceJet jet = surface(patch, u(row), v(column));
        const Eigen::Vector3d members[6] = {jet.s, jet.su, jet.sv, jet.suu, jet.suv, jet.svv};
        for (int i = 0; i < 6; ++i) grids_[i].block<1, 3>(row, 3 * column) = members[i].transpose();
      }
}

void FaceSample::dealRows(int rows) {
  const RowLayout layout(rows, false);
  for (int patch = 0; patch < FaceLayout::patchCount; ++patch) {
    const std::vector<double> u = rowsOfPatch(layout, patch);
    u_.insert(u_.end(), u.begin(), u.end());
    firstRow_[patch + 1] = rowCount();
  }
}

// A row on a curve between two pieces goes to the upper one.
void FaceSample::dealRowsTo(std::vector<SurfacePiece>& pieces) const {
  const int piecesPerPatch = static_cast<int>(pieces.size()) / FaceLayout::patchCount;
  for (int patch = 0; patch < FaceLayout::patchCount; ++patch)
    for (int i = 0, next = firstRow(patch); i < piecesPerPatch; ++i) {
      SurfacePiece& piece = pieces[patch * piecesPerPatch + i];
      piece.firstRow = next;
      for (piece.u.clear(); next < firstRow(patch + 1) && u(next) <= piece.end; ++next) piece.u.push_back(u(next));
    }
}

SurfaceJet FaceSample::jet(int row, int column) const {
  SurfaceJet jet;
  Eigen::Vector3d* const members[6] = {&jet.s, &jet.su, &jet.sv, &jet.suu, &jet.suv, &jet.svv};
  for (int i = 0; i < 6; ++i) *members[i] = vectorOf(grids_[i], row, column);
  return jet;
}

Eigen::Vector3d FaceSample::areaVector(int row, int column) const {
  return vectorOf(grids_[1], row, column).cross(vectorOf(grids_[2], row, column));
}

double FaceSample::areaElement(int row, int column) const {
  return areaVector(row, column).norm();
}

}  // namespace mien
