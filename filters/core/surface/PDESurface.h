#pragma once

#include <memory>
#include <string>
#include <vector>

#include "BoundaryData.h"
#include "BoundaryField.h"
#include "SurfacePiece.h"

namespace mien {

/// Older than every version of a surface.
constexpr long noVersion = -1;

/// Some rows of one strip of columns.
struct SurfacePart {
  int strip, firstRow, rows;
};

/// A surface of pieces on one grid, re-evaluated for ever new curves: S = U B.
///
/// U depends on the pieces, a and N only and is made once. B, the boundary data of all pieces, is made from the curves:
/// of a grid of one strip of columns it is kept and changes where they do, of a wider one it is made strip by strip.
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

  int stripCount() const { return fields_.front().stripCount(); }
  int columnsOf(int strip) const { return fields_.front().columnsOf(strip); }

  /// New curves; no allocation after the first time. Of those that are what they were only the samples are compared.
  void setCurves(const ClosedCurves& curves);

  /// Counts the curves that were set.
  long version() const { return version_; }

  using Grid = Eigen::Map<RowMajor<Scalar>>;

  /// Rows firstRow .. firstRow + grid.rows() - 1 of a derivative of S; orders 0, 0 are S itself. Safe to call
  /// from several threads.
  void evaluate(int orderU, int orderV, int firstRow, Grid grid) const;

  /// Rows of S and of its unit normals, which point outwards, in one go, and of its tangent vectors where they are
  /// wanted. The bits of S, S_u and S_v are those of evaluate(). Safe to call from several threads.
  /// @param since  what the grids hold is this version of the surface: pieces that are the same still are left alone
  void evaluateWithNormals(int firstRow, Grid s, Grid normals, Grid* su = nullptr, Grid* sv = nullptr,
                           long since = noVersion) const;

  /// The same of a part, into rows that begin at its first row and column.
  void evaluate(int orderU, int orderV, const SurfacePart& part, const OutputRows<Scalar>& out) const;
  /// @return whether there is a normal everywhere; those that are 0 wait for repeatNormals()
  bool evaluateWithNormals(const SurfacePart& part, const SurfaceRowsOutput<Scalar>& out, long since = noVersion) const;

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
  void update(const DataRange& changed);
  long latestOf(const std::vector<int>& data) const;
  OperatorRows<Scalar> rowsOf(const Block& block, int order, const SurfacePart& part) const;
  BoundaryPlanes<Scalar> boundary(int order, int strip) const;

  HarmonicSplit split_;
  BoundaryData data_;
  int columnCount_, rowCount_ = 0;
  std::vector<Block> u_;
  std::unique_ptr<BoundaryCoefficients> coefficients_;
  Eigen::Array<Scalar, Eigen::Dynamic, 1> rounded_;  ///< the coefficients
  std::vector<BoundaryField<Scalar>> fields_;        ///< by order of the derivative
  std::vector<AlignedRows<Scalar>> b_;               ///< by order of the derivative: B, where there is one strip only
  long version_ = 0;
  std::vector<long> changes_;  ///< by datum: the version that changed it
  std::string fault_;
};

extern template class PDESurface<float>;
extern template class PDESurface<double>;

}  // namespace mien
