#include "PDESurface.h"

#include <algorithm>

namespace mien {

template <class Scalar>
PDESurface<Scalar>::PDESurface(const std::vector<SurfacePiece>& pieces, const HarmonicSplit& split, int curveCount,
                               const Eigen::VectorXd& v, int derivatives)
    : split_(split), data_(split, curveCount), columnCount_(static_cast<int>(v.size())) {
  for (const SurfacePiece& piece : pieces)
    if (!piece.u.empty()) addBlock(piece, data_.add(piece), derivatives);
  placeData();
  coefficients_ = std::make_unique<BoundaryCoefficients>(split, curveCount, data_.count());
  for (int order = 0; order <= derivatives; ++order) b_.emplace_back(split, v, order);
}

template <class Scalar>
void PDESurface<Scalar>::addBlock(const SurfacePiece& piece, std::vector<int> data, int derivatives) {
  rowCount_ = std::max(rowCount_, piece.firstRow + static_cast<int>(piece.u.size()));
  Block block{piece.firstRow, std::move(data), {}, {}};
  const auto conditions = static_cast<Eigen::Index>(block.data.size());
  for (int order = 0; order <= derivatives; ++order) {
    RowMajor<Scalar>& matrix = block.matrices.emplace_back(piece.u.size(), conditions * split_.count());
    for (int part = 0; part < split_.count(); ++part) {
      const Eigen::MatrixXd u = pieceOperator(piece, split_, part, order);
      if (u.size() == 0) {
        fault_ = "the conditions of a patch do not determine a surface; give as many independent ones as its order";
        return;
      }
      matrix.middleCols(part * conditions, conditions) = u.template cast<Scalar>();
    }
  }
  u_.push_back(std::move(block));
}

/// Row j D + d of B is part j of datum d, and D is known only when all pieces have told their data.
template <class Scalar>
void PDESurface<Scalar>::placeData() {
  for (Block& block : u_)
    for (int part = 0; part < split_.count(); ++part)
      for (const int datum : block.data) block.places.push_back(static_cast<long>(part) * data_.count() + datum);
}

template <class Scalar>
void PDESurface<Scalar>::setCurves(const ClosedCurves& curves) {
  coefficients_->setCurves(curves);
  data_.derive(*coefficients_);
  rounded_.assign(coefficients_->values().begin(), coefficients_->values().end());
  for (BoundaryField<Scalar>& b : b_) b.update(rounded_.data(), data_.count());
}

/// Those of a block's rows that lie in firstRow .. endRow - 1; maybe none.
template <class Scalar>
OperatorRows<Scalar> PDESurface<Scalar>::rowsOf(const Block& block, int order, int firstRow, int endRow) const {
  const RowMajor<Scalar>& u = block.matrices[order];
  const int begin = std::max(firstRow - block.firstRow, 0);
  const int end = std::min(endRow - block.firstRow, static_cast<int>(u.rows()));
  return {u.data() + begin * u.cols(), std::max(0, end - begin), static_cast<int>(u.cols()), block.places.data()};
}

// S = U B, piece by piece.
template <class Scalar>
void PDESurface<Scalar>::evaluate(int orderU, int orderV, int firstRow, Grid grid) const {
  const int endRow = firstRow + static_cast<int>(grid.rows());
  for (const Block& block : u_) {
    const OperatorRows<Scalar> u = rowsOf(block, orderU, firstRow, endRow);
    if (u.rows == 0) continue;
    Scalar* const out = grid.row(std::max(firstRow, block.firstRow) - firstRow).data();
    vectorRows<Scalar>(u, b_[orderV].planes(), {out, grid.cols()});
  }
}

template <class Scalar>
void PDESurface<Scalar>::evaluateWithNormals(int firstRow, Grid s, Grid normals, Grid* su, Grid* sv) const {
  const int endRow = firstRow + static_cast<int>(s.rows());
  for (const Block& block : u_) {
    const OperatorRows<Scalar> u = rowsOf(block, 0, firstRow, endRow), slopes = rowsOf(block, 1, firstRow, endRow);
    if (u.rows == 0) continue;
    const auto rowsFrom = [&](Grid* grid) {
      const int row = std::max(firstRow, block.firstRow) - firstRow;
      return grid ? OutputRows<Scalar>{grid->row(row).data(), grid->cols()} : OutputRows<Scalar>();
    };
    surfaceRows<Scalar>(u, slopes.first, b_[0].planes(), b_[1].planes().first,
                        {rowsFrom(&s), rowsFrom(&normals), rowsFrom(su), rowsFrom(sv)});
  }
}

template class PDESurface<float>;
template class PDESurface<double>;

}  // namespace mien
