#include "PDESurface.h"

#include "RowProduct.h"

#include <algorithm>

namespace mien {

namespace {

/// First and last curve (J columns each) that a part of U uses at all.
std::pair<int, int> usedCurves(const Eigen::MatrixXd& u, int parts) {
  const int curves = static_cast<int>(u.cols()) / parts;
  int first = curves, last = -1;
  for (int c = 0; c < curves; ++c) {
    if ((u.middleCols(c * parts, parts).array() == 0.0).all()) continue;
    first = std::min(first, c);
    last = c;
  }
  return last < 0 ? std::make_pair(0, 0) : std::make_pair(first, last);
}

}  // namespace

template <class Scalar>
PDESurface<Scalar>::PDESurface(const std::vector<SurfacePiece>& pieces, const HarmonicSplit& split, int curveCount,
                               const Eigen::VectorXd& v, int derivatives)
    : split_(split),
      curveCount_(curveCount),
      columnCount_(static_cast<int>(v.size())),
      analysis_(split.analysis()),
      u_(derivatives + 1) {
  for (int order = 0; order <= derivatives; ++order) {
    b_.emplace_back(split, v, order);
    for (const SurfacePiece& piece : pieces) addBlock(piece, order);
  }
}

template <class Scalar>
void PDESurface<Scalar>::addBlock(const SurfacePiece& piece, int derivative) {
  if (piece.u.empty()) return;
  rowCount_ = std::max(rowCount_, piece.firstRow + static_cast<int>(piece.u.size()));
  const Eigen::MatrixXd u = surfaceOperator(piece, split_, curveCount_, derivative);
  if (u.size() == 0) {
    fault_ = "the conditions of a patch do not determine a surface; give as many independent ones as its order";
    return;
  }
  const auto [first, last] = usedCurves(u, split_.count());
  const auto used = u.middleCols(first * split_.count(), (last - first + 1) * split_.count());
  u_[derivative].push_back({piece.firstRow, first, used.template cast<Scalar>()});
}

template <class Scalar>
void PDESurface<Scalar>::setCurves(const ClosedCurves& curves) {
  fourierCoefficients(analysis_, curves, samples_, coefficients_);
  for (BoundaryField<Scalar>& b : b_) b.update(coefficients_);
}

// S = U B, piece by piece.
template <class Scalar>
void PDESurface<Scalar>::evaluate(int orderU, int orderV, int firstRow, Grid grid) const {
  const BoundaryField<Scalar>& b = b_[orderV];
  const int endRow = firstRow + static_cast<int>(grid.rows());
  for (const Block& u : u_[orderU]) {
    const int begin = std::max(firstRow, u.firstRow);
    const int end = std::min(endRow, u.firstRow + static_cast<int>(u.matrix.rows()));
    if (begin >= end) continue;
    rowProduct(u.matrix.row(begin - u.firstRow).data(), end - begin, static_cast<int>(u.matrix.cols()),
               b.matrix().row(u.firstCurve * b.partCount()).data(), b.matrix().cols(), static_cast<int>(grid.cols()),
               grid.row(begin - firstRow).data(), grid.cols());
  }
}

template class PDESurface<float>;
template class PDESurface<double>;

}  // namespace mien
