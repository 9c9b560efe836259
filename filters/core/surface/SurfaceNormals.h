#pragma once

#include "BoundaryField.h"

namespace mien {

/// Unit normals S_u x S_v / |S_u x S_v|, which point outwards, of rows of a grid laid out as PDESurface's.
///
/// Where the surface has no tangent plane (lids in contact), the normal of the column before is repeated.
template <class Scalar>
void surfaceNormals(const Eigen::Map<RowMajor<Scalar>>& su, const Eigen::Map<RowMajor<Scalar>>& sv,
                    Eigen::Map<RowMajor<Scalar>> normals);

}  // namespace mien
