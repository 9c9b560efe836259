#include "SurfacePiece.h"

#include <algorithm>

#include "ModeOperator.h"

namespace mien {

namespace {

ModeOperator modeOperator(const SurfacePiece& piece, const HarmonicSplit& split, int part) {
  return ModeOperator(split.rate(part, piece.smoothing), piece.conditions, piece.begin, piece.end);
}

}  // namespace

Eigen::MatrixXd dataOfConditions(const SurfacePiece& piece, int part) {
  const Eigen::MatrixXd data = piece.boundaryData(part);
  Eigen::MatrixXd chosen(piece.conditions.size(), data.cols());
  for (size_t i = 0; i < piece.conditions.size(); ++i) chosen.row(i) = data.row(piece.conditions[i].curve);
  return chosen;
}

Eigen::MatrixXd pieceOperator(const SurfacePiece& piece, const HarmonicSplit& split, int part, int derivative) {
  const ModeOperator mode = modeOperator(piece, split, part);
  if (!mode.solvable()) return {};
  Eigen::MatrixXd u(piece.u.size(), piece.conditions.size());
  for (size_t row = 0; row < piece.u.size(); ++row) u.row(row) = mode.row(piece.u[row], derivative);
  return u;
}

Eigen::MatrixXd surfaceOperator(const SurfacePiece& piece, const HarmonicSplit& split, int curveCount, int derivative) {
  const int parts = split.count();
  Eigen::MatrixXd result(piece.u.size(), curveCount * parts);
  for (int part = 0; part < parts; ++part) {
    const Eigen::MatrixXd u = pieceOperator(piece, split, part, derivative);
    if (u.size() == 0) return {};
    const Eigen::MatrixXd product = u * dataOfConditions(piece, part);
    for (int c = 0; c < curveCount; ++c) result.col(c * parts + part) = product.col(c);
  }
  return result;
}

double lebesgueConstant(const SurfacePiece& piece, const HarmonicSplit& split) {
  double largest = 0.0;
  for (int part = 0; part < split.count(); ++part)
    largest = std::max(largest, modeOperator(piece, split, part).lebesgueConstant());
  return largest;
}

}  // namespace mien
