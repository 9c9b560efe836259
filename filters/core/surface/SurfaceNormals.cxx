#include "SurfaceNormals.h"

#include <cmath>
#include <limits>

namespace mien {

namespace {

/// Writes one unit normal; false where S_u and S_v are parallel or vanish.
template <class Scalar>
bool unitNormal(const Scalar* u, const Scalar* v, Scalar* normal) {
  const Scalar x = u[1] * v[2] - u[2] * v[1];
  const Scalar y = u[2] * v[0] - u[0] * v[2];
  const Scalar z = u[0] * v[1] - u[1] * v[0];
  const Scalar squared = x * x + y * y + z * z;
  if (!(squared > std::numeric_limits<Scalar>::min())) return false;
  const Scalar inverse = Scalar(1) / std::sqrt(squared);
  normal[0] = x * inverse;
  normal[1] = y * inverse;
  normal[2] = z * inverse;
  return true;
}

}  // namespace

template <class Scalar>
void surfaceNormals(const Eigen::Map<RowMajor<Scalar>>& su, const Eigen::Map<RowMajor<Scalar>>& sv,
                    Eigen::Map<RowMajor<Scalar>> normals) {
  for (Eigen::Index row = 0; row < su.rows(); ++row) {
    const Scalar* u = su.row(row).data();
    const Scalar* v = sv.row(row).data();
    Scalar* normal = normals.row(row).data();
    Scalar last[3] = {0, 0, 1};
    for (Eigen::Index i = 0; i < su.cols(); i += 3) {
      if (!unitNormal(u + i, v + i, normal + i)) std::copy(last, last + 3, normal + i);
      std::copy(normal + i, normal + i + 3, last);
    }
  }
}

template void surfaceNormals<float>(const Eigen::Map<RowMajor<float>>&, const Eigen::Map<RowMajor<float>>&,
                                    Eigen::Map<RowMajor<float>>);
template void surfaceNormals<double>(const Eigen::Map<RowMajor<double>>&, const Eigen::Map<RowMajor<double>>&,
                                     Eigen::Map<RowMajor<double>>);

}  // namespace mien
