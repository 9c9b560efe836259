#pragma once

#include <memory>
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

  /// Rows of S and of its unit normals, which point outwards, in one go, and of its tangent vectors where they are
  /// wanted. The bits of S, S_u and S_v are those of evaluate(). Safe to call from several threads.
  void evaluateWithNormals(int firstRow, Grid s, Grid normals, Grid* su = nullptr, Grid* sv = nullptr) const;

 private:
  /// The part of U that belongs to one piece.
  struct Block {
    int firstRow;
    std::vector<int> data;                   ///< by condition
    std::vector<long> places;                ///< by column of U: the row of B
    std::vector<RowMajor<Scalar>> matrices;  ///< by order of the derivative: rows x (part by part, the conditions)
  };

  void addBlock(const SurfacePiece& piece, std::vector<int> data, int derivatives);
  void placeData();
  OperatorRows<Scalar> rowsOf(const Block& block, int order, int firstRow, int endRow) const;

  HarmonicSplit split_;
  BoundaryData data_;
  int columnCount_, rowCount_ = 0;
  std::vector<Block> u_;
  std::unique_ptr<BoundaryCoefficients> coefficients_;
  std::vector<Scalar> rounded_;           ///< the coefficients
  std::vector<BoundaryField<Scalar>> b_;  ///< by order of the derivative
  std::string fault_;
};

extern template class PDESurface<float>;
extern template class PDESurface<double>;

}  // namespace mien
