#include "FaceSeams.h"

#include <cmath>

#include "BoundaryCoefficients.h"

namespace mien {

namespace {

constexpr int sideCount = 2 * FaceSeams::seamCount;
constexpr int orderCount = 3;  ///< S, S_u, S_uu

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
    }
  return borders;
}

}  // namespace

FaceSeams::FaceSeams(const FaceSurfaceOptions& options, int pointsPerCurve, int columns)
    : v_(equidistant(columns)),
      split_(pointsPerCurve, options.modes, options.remainder),
      analysis_(split_.analysis()),
      synthesis_{split_.synthesis(v_, 0), split_.synthesis(v_, 1), split_.synthesis(v_, 2)},
      sides_(split_.count(), Eigen::MatrixXd::Zero(3 * FaceLayout::curveCount, 3 * sideCount * orderCount)),
      measures_(static_cast<size_t>(seamCount) * columns) {
  int row = 0;
  for (const SurfacePiece& border : bordersOfSeams(options)) addSide(border, row++);
}

// A derivative at a border is a combination of the curves, harmonic by harmonic, the same for x, y and z.
void FaceSeams::addSide(const SurfacePiece& piece, int row) {
  for (int order = 0; order < orderCount; ++order) {
    const Eigen::MatrixXd u = surfaceOperator(piece, split_, FaceLayout::curveCount, order);
    if (u.size() == 0) {
      fault_ = "the conditions of a patch do not determine a surface; give as many independent ones as its order";
      return;
    }
    for (int part = 0; part < split_.count(); ++part)
      for (int c = 0; c < FaceLayout::curveCount; ++c)
        for (int xyz = 0; xyz < 3; ++xyz)
          sides_[part](3 * c + xyz, 3 * (order * sideCount + row) + xyz) = u(0, c * split_.count() + part);
  }
}

std::string FaceSeams::name(int seam) {
  return "P" + std::to_string(seam) + "|P" + std::to_string(seam + 1);
}

void FaceSeams::setCurves(const ClosedCurves& curves) {
  computeJets(curves);
  for (int seam = 0; seam < seamCount; ++seam) measure(seam);
}

// Curves are combined as coefficients, 40 numbers each, and only the results are sampled.
void FaceSeams::computeJets(const ClosedCurves& curves) {
  fourierCoefficients(analysis_, curves, samples_, ofCurves_);
  ofSides_.setZero(ofCurves_.rows(), 3 * sideCount * orderCount);
  for (int part = 0; part < split_.count(); ++part) {
    const int first = split_.firstCoefficient(part), count = split_.coefficientCount(part);
    if (count > 0) ofSides_.middleRows(first, count).noalias() = ofCurves_.middleRows(first, count) * sides_[part];
  }
  for (int order = 0; order < orderCount; ++order)
    jets_[order].noalias() = synthesis_[order] * ofSides_.leftCols(3 * sideCount * (orderCount - order));
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
  const auto value = [&](int orderU, int orderV) -> Eigen::Vector3d {
    return jets_[orderV].block<1, 3>(column, 3 * (orderU * sideCount + 2 * seam + side)).transpose();
  };
  return {value(0, 0), value(1, 0), value(0, 1), value(2, 0), value(1, 1), value(0, 2)};
}

Eigen::Vector3d FaceSeams::position(int seam, int column) const {
  const auto sides = jets_[0].block<1, 6>(column, 6 * seam);
  return 0.5 * (sides.leftCols<3>() + sides.rightCols<3>()).transpose();
}

}  // namespace mien
