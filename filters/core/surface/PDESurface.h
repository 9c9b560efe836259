#pragma once

#include <string>
#include <vector>

#include "BoundaryData.h"
#include "BoundaryField.h"
#include "SurfacePiece.h"

namespace mien {

/// A surface of pieces on one grid, re-evaluated for ever new curves: S = U B.
///
/// U depends on the pieces, a and N only and is made once; B, the boundary data of all pieces at every column, is made
/// from the curves each time.
/// Grids are row-major: (rows) x (x, y, z of column 0, of column 1, ...), mm.
template <class Scalar>
class PDESurface {
 public:
  /// @param curveCount   curves that every piece's boundaryData combines
  /// @param v            columns of the grid, radians
  /// @param derivatives  highest order of derivatives wanted, with respect to u and to v
  PDESurface(const std::vector<SurfacePiece>& pieces, const HarmonicSplit& split, int curveCount,
             const Eigen::VectorXd& v, int derivatives = 1);

  /// One sentence that says which piece's conditions determine no surface, or nothing.
  const std::string& fault() const { return fault_; }

  int rowCount() const { return rowCount_; }
  int columnCount() const { return columnCount_; }

  /// New curves; no allocation after the first time.
  void setCurves(const ClosedCurves& curves);

  using Grid = Eigen::Map<RowMajor<Scalar>>;

  /// Rows firstRow .. firstRow + grid.rows() - 1 of a derivative of S; orders 0, 0 are S itself. Safe to call
  /// from several threads.
  void evaluate(int orderU, int orderV, int firstRow, Grid grid) const;

 private:
  /// The part of U that belongs to one piece, over the run of data that it uses.
  struct Block {
    int firstRow, firstDatum;
    RowMajor<Scalar> matrix;
  };

  void addBlock(const SurfacePiece& piece, const std::vector<int>& data, int derivative);

  HarmonicSplit split_;
  BoundaryData data_;
  int columnCount_, rowCount_ = 0;
  Eigen::MatrixXd analysis_, samples_, coefficients_, dataCoefficients_;
  std::vector<BoundaryField<Scalar>> b_;  ///< by order of the derivative
  std::vector<std::vector<Block>> u_;     ///< by order of the derivative
  std::string fault_;
};

extern template class PDESurface<float>;
extern template class PDESurface<double>;

}  // namespace mien
