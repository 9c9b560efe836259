#include "FaceSeams.h"

#include <cmath>

namespace mien {

namespace {

/// Order of the derivatives with respect to u and v of the grids of a jet.
constexpr std::array<std::array<int, 2>, 6> jetOrders = {{{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};

Eigen::VectorXd equidistant(int columns) {
  return Eigen::VectorXd::LinSpaced(columns, 0.0, 2.0 * M_PI * (columns - 1) / columns);
}

/// The last piece of the patch above each seam and the first of the patch below, with their border as the only row.
std::vector<SurfacePiece> bordersOfSeams(const FaceSurfaceOptions& options) {
  const std::vector<SurfacePiece> pieces = facePieces(options, RowLayout(RowLayout::minimumRows, false));
  const int perPatch = static_cast<int>(pieces.size()) / FaceLayout::patchCount;
  std::vector<SurfacePiece> borders;
  for (int seam = 0; seam < FaceSeams::seamCount; ++seam)
    for (int side = 0; side < 2; ++side) {
      borders.push_back(pieces[(seam + 1) * perPatch - 1 + side]);
      SurfacePiece& border = borders.back();
      border.u = {side == 0 ? border.end : border.begin};
      border.firstRow = 2 * seam + side;
    }
  return borders;
}

}  // namespace

FaceSeams::FaceSeams(const FaceSurfaceOptions& options, int pointsPerCurve, int columns)
    : v_(equidistant(columns)),
      surface_(bordersOfSeams(options), HarmonicSplit(pointsPerCurve, options.modes, options.remainder), FaceLayout::curveCount, v_, 2),
      measures_(static_cast<size_t>(seamCount) * columns) {}

std::string FaceSeams::name(int seam) { return "P" + std::to_string(seam) + "|P" + std::to_string(seam + 1); }

void FaceSeams::setCurves(const ClosedCurves& curves) {
  surface_.setCurves(curves);
  for (size_t i = 0; i < grids_.size(); ++i) {
    grids_[i].resize(2 * seamCount, 3 * columnCount());
    surface_.evaluate(jetOrders[i][0], jetOrders[i][1], 0, {grids_[i].data(), grids_[i].rows(), grids_[i].cols()});
  }
  for (int seam = 0; seam < seamCount; ++seam) measure(seam);
}

void FaceSeams::measure(int seam) {
  whole_[seam] = frontal_[seam] = SeamSummary();
  for (int column = 0; column < columnCount(); ++column) {
    const SeamMeasures sample(jet(seam, 0, column), jet(seam, 1, column));
    measures_[seam * columnCount() + column] = sample;
    whole_[seam].add(sample);
    if (position(seam, column).z() > frontalZ) frontal_[seam].add(sample);
  }
}

SurfaceJet FaceSeams::jet(int seam, int side, int column) const {
  const auto value = [&](int i) -> Eigen::Vector3d { return grids_[i].block<1, 3>(2 * seam + side, 3 * column).transpose(); };
  return {value(0), value(1), value(2), value(3), value(4), value(5)};
}

Eigen::Vector3d FaceSeams::position(int seam, int column) const {
  const auto& s = grids_[0];
  return 0.5 * (s.block<1, 3>(2 * seam, 3 * column) + s.block<1, 3>(2 * seam + 1, 3 * column)).transpose();
}

}  // namespace mien
