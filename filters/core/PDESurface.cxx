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
                               const Eigen::VectorXd& v)
    : split_(split),
      curveCount_(curveCount),
      columnCount_(static_cast<int>(v.size())),
      analysis_(split.analysis()),
      b_(split, v, 0),
      bDerivative_(split, v, 1) {
  for (const SurfacePiece& piece : pieces) {
    if (piece.u.empty()) continue;
    addBlock(piece, 0, u_);
    addBlock(piece, 1, uDerivative_);
    rowCount_ = std::max(rowCount_, piece.firstRow + static_cast<int>(piece.u.size()));
  }
}

template <class Scalar>
void PDESurface<Scalar>::addBlock(const SurfacePiece& piece, int derivative, std::vector<Block>& blocks) {
  const Eigen::MatrixXd u = surfaceOperator(piece, split_, curveCount_, derivative);
  if (u.size() == 0) {
    fault_ = "the conditions of a patch do not determine a surface; give as many independent ones as its order";
    return;
  }
  const auto [first, last] = usedCurves(u, split_.count());
  const auto used = u.middleCols(first * split_.count(), (last - first + 1) * split_.count());
  blocks.push_back({piece.firstRow, first, used.template cast<Scalar>()});
}

template <class Scalar>
void PDESurface<Scalar>::setCurves(const ClosedCurves& curves) {
  fourierCoefficients(analysis_, curves, samples_, coefficients_);
  b_.update(coefficients_);
  bDerivative_.update(coefficients_);
}

// S = U B, piece by piece.
template <class Scalar>
void PDESurface<Scalar>::evaluate(const std::vector<Block>& u, const BoundaryField<Scalar>& b, int firstRow, Grid& grid) const {
  const int endRow = firstRow + static_cast<int>(grid.rows());
  for (const Block& block : u) {
    const int begin = std::max(firstRow, block.firstRow);
    const int end = std::min(endRow, block.firstRow + static_cast<int>(block.matrix.rows()));
    if (begin >= end) continue;
    const Scalar* u0 = block.matrix.row(begin - block.firstRow).data();
    const Scalar* b0 = b.matrix().row(block.firstCurve * b.partCount()).data();
    rowProduct(u0, end - begin, static_cast<int>(block.matrix.cols()), b0, b.matrix().cols(), static_cast<int>(grid.cols()),
               grid.row(begin - firstRow).data(), grid.cols());
  }
}

template class PDESurface<float>;
template class PDESurface<double>;

}  // namespace mien
