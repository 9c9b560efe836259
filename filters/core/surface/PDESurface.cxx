#include "PDESurface.h"

#include <algorithm>

#include "RowProduct.h"

namespace mien {

template <class Scalar>
PDESurface<Scalar>::PDESurface(const std::vector<SurfacePiece>& pieces, const HarmonicSplit& split, int curveCount,
                               const Eigen::VectorXd& v, int derivatives)
    : split_(split),
      data_(split, curveCount),
      columnCount_(static_cast<int>(v.size())),
      analysis_(split.analysis()),
      u_(derivatives + 1) {
  for (int order = 0; order <= derivatives; ++order) b_.emplace_back(split, v, order);
  for (const SurfacePiece& piece : pieces) {
    if (piece.u.empty()) continue;
    rowCount_ = std::max(rowCount_, piece.firstRow + static_cast<int>(piece.u.size()));
    const std::vector<int> data = data_.add(piece);
    for (int order = 0; order <= derivatives; ++order) addBlock(piece, data, order);
  }
}

template <class Scalar>
void PDESurface<Scalar>::addBlock(const SurfacePiece& piece, const std::vector<int>& data, int derivative) {
  const auto [first, last] = std::minmax_element(data.begin(), data.end());
  const int parts = split_.count();
  RowMajor<Scalar> matrix = RowMajor<Scalar>::Zero(piece.u.size(), (*last - *first + 1) * parts);
  for (int part = 0; part < parts; ++part) {
    const Eigen::MatrixXd u = pieceOperator(piece, split_, part, derivative);
    if (u.size() == 0) {
      fault_ = "the conditions of a patch do not determine a surface; give as many independent ones as its order";
      return;
    }
    for (size_t i = 0; i < data.size(); ++i)
      matrix.col((data[i] - *first) * parts + part) += u.col(i).template cast<Scalar>();
  }
  u_[derivative].push_back({piece.firstRow, *first, std::move(matrix)});
}

template <class Scalar>
void PDESurface<Scalar>::setCurves(const ClosedCurves& curves) {
  fourierCoefficients(analysis_, curves, samples_, coefficients_);
  data_.derive(coefficients_, dataCoefficients_);
  for (BoundaryField<Scalar>& b : b_) b.update(dataCoefficients_);
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
               b.matrix().row(u.firstDatum * b.partCount()).data(), b.matrix().cols(), static_cast<int>(grid.cols()),
               grid.row(begin - firstRow).data(), grid.cols());
  }
}

template class PDESurface<float>;
template class PDESurface<double>;

}  // namespace mien
