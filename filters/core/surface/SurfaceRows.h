#pragma once

#include <vector>

namespace mien {

/// Columns that are computed at once, a strip: their part of B stays in the second cache while rows run.
constexpr int columnsOfStrip = 64;

/// B as the kernels read it: rows of three planes, the x of all columns, then y, then z.
template <class Scalar>
struct BoundaryPlanes {
  const Scalar* first = nullptr;
  long plane = 0;  ///< distance of the planes: the columns, padded to whole vectors
  int columns = 0;

  long rowStride() const { return 3 * plane; }
};

/// Rows of U that share their data, and where these stand in B.
template <class Scalar>
struct OperatorRows {
  const Scalar* first = nullptr;  ///< rows x depth, contiguous
  int rows = 0, depth = 0;
  const long* places = nullptr;  ///< by k: the row of B
};

/// x, y, z of column 0, of column 1, ... in rows `stride` apart; may be none.
template <class Scalar>
struct OutputRows {
  Scalar* first = nullptr;
  long stride = 0;

  Scalar* at(int row, int column) const { return first + row * stride + 3L * column; }
  OutputRows below(int row) const { return first ? OutputRows{at(row, 0), stride} : *this; }
};

/// out = U B. Every element is summed over k in its order, wherever it stands.
template <class Scalar>
void vectorRows(const OperatorRows<Scalar>& u, const BoundaryPlanes<Scalar>& b, const OutputRows<Scalar>& out);

/// S = U B and its tangent vectors and unit normal at once.
template <class Scalar>
struct SurfaceRowsOutput {
  OutputRows<Scalar> s, normal;
  OutputRows<Scalar> su, sv;  ///< where they are wanted

  SurfaceRowsOutput below(int row) const { return {s.below(row), normal.below(row), su.below(row), sv.below(row)}; }
};

/// S, S_u = U' B, S_v = U B' and the unit normal S_u x S_v / |S_u x S_v|, which points outwards.
///
/// @param uDerivative  U', rows and places as u's
/// @param bDerivative  B', planes as b's
/// @return whether there is a normal everywhere; it is 0 where the surface has no tangent plane (lids in contact)
template <class Scalar>
bool surfaceRows(const OperatorRows<Scalar>& u, const Scalar* uDerivative, const BoundaryPlanes<Scalar>& b,
                 const Scalar* bDerivative, const SurfaceRowsOutput<Scalar>& out);

/// Where a normal is 0, that of the column before is repeated; (0, 0, 1) where none is before.
template <class Scalar>
void repeatNormals(int rows, int columns, const OutputRows<Scalar>& normals);

}  // namespace mien
