#include "SurfaceRows.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ProcessorVectors.h"

namespace mien {

namespace {

/// Three vectors x, y, z as one after the other would be stored: part 0, 1 or 2 of x0 y0 z0 x1 ...
template <int part, class Vector, int... lane>
MIEN_INLINE Vector interleavedPart(const Vector& x, const Vector& y, const Vector& z,
                                   std::integer_sequence<int, lane...>) {
  constexpr int lanes = sizeof...(lane), first = part * lanes;
  const Vector xy = __builtin_shufflevector(x, y, ((first + lane) / 3 + ((first + lane) % 3 == 1 ? lanes : 0))...);
  return __builtin_shufflevector(xy, z, ((first + lane) % 3 == 2 ? lanes + (first + lane) / 3 : lane)...);
}

/// As many points as a vector has lanes.
template <class Vector>
struct Points {
  Vector x, y, z;

  template <class Scalar>
  MIEN_INLINE void addWeighted(Scalar weight, const Points& other) {
    x += weight * other.x;
    y += weight * other.y;
    z += weight * other.z;
  }

  template <class Scalar>
  static MIEN_INLINE Points load(const Scalar* row, long plane) {
    return {loadVector<Vector>(row), loadVector<Vector>(row + plane), loadVector<Vector>(row + 2 * plane)};
  }

  /// Asks for the memory that store() will write: it comes while sums are computed.
  template <class Scalar>
  static MIEN_INLINE void prepareStore(const Scalar* out) {
    constexpr int line = 64 / sizeof(Scalar), numbers = 3 * sizeof(Vector) / sizeof(Scalar);
    for (int i = 0; i < numbers; i += line) __builtin_prefetch(out + i, 1);
  }

  /// The first `columns` of them.
  template <class Scalar>
  MIEN_INLINE void store(int columns, Scalar* out) const {
    constexpr int lanes = sizeof(Vector) / sizeof(Scalar);
    constexpr std::make_integer_sequence<int, lanes> sequence;
    storeSome<lanes>(interleavedPart<0>(x, y, z, sequence), 3 * columns, out);
    storeSome<lanes>(interleavedPart<1>(x, y, z, sequence), 3 * columns - lanes, out + lanes);
    storeSome<lanes>(interleavedPart<2>(x, y, z, sequence), 3 * columns - 2 * lanes, out + 2 * lanes);
  }
};

template <class Vector>
MIEN_INLINE Points<Vector> cross(const Points<Vector>& u, const Points<Vector>& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

template <class Scalar>
struct VectorRowsKernel {
  template <int bytes>
  static MIEN_INLINE void run(const OperatorRows<Scalar>& u, const BoundaryPlanes<Scalar>& b,
                              const OutputRows<Scalar>& out) {
    forTiles<VectorOf<Scalar, bytes>::lanes, 4>(u.rows, b.columns, [&](auto rows, int row, int column) MIEN_ALWAYS {
      tile<typename VectorOf<Scalar, bytes>::Type>(rows, u, row, b, column, out);
    });
  }

  template <class Vector, int... i>
  static MIEN_INLINE void tile(std::integer_sequence<int, i...>, const OperatorRows<Scalar>& u, int row,
                               const BoundaryPlanes<Scalar>& b, int column, const OutputRows<Scalar>& out) {
    const Scalar* const weights = u.first + static_cast<long>(row) * u.depth;
    Points<Vector> sums[sizeof...(i)] = {};
    for (int k = 0; k < u.depth; ++k) {
      const auto value = Points<Vector>::load(b.first + u.places[k] * b.rowStride() + column, b.plane);
      (sums[i].addWeighted(weights[i * u.depth + k], value), ...);
    }
    (sums[i].store(b.columns - column, out.at(row + i, column)), ...);
  }
};

/// 1 / length, or 0 where there is no tangent plane, and the smallest so far.
///
/// Lane by lane: compilers make vectors of a loop that is kept, and lanes of a comparison of vectors.
template <class Scalar, int lanes>
MIEN_INLINE void inverseLengths(const Scalar* squared, Scalar* inverse, Scalar* smallest) {
#pragma GCC unroll 1
  for (int i = 0; i < lanes; ++i) {
    const Scalar root = Scalar(1) / std::sqrt(squared[i]);
    inverse[i] = squared[i] > std::numeric_limits<Scalar>::min() ? root : Scalar(0);
    smallest[i] = inverse[i] < smallest[i] ? inverse[i] : smallest[i];
  }
}

/// Sums of S, S_u and S_v in one row.
template <class Scalar, int bytes>
struct SurfaceSums {
  using Vector = typename VectorOf<Scalar, bytes>::Type;
  static constexpr int lanes = VectorOf<Scalar, bytes>::lanes;

  Points<Vector> s, su, sv;

  MIEN_INLINE void add(Scalar weight, Scalar weightOfSlope, const Points<Vector>& value, const Points<Vector>& slope) {
    s.addWeighted(weight, value);
    su.addWeighted(weightOfSlope, value);
    sv.addWeighted(weight, slope);
  }

  MIEN_INLINE Points<Vector> unitNormals(Scalar* smallest) const {
    const Points<Vector> normal = cross(su, sv);
    const Vector squared = normal.x * normal.x + normal.y * normal.y + normal.z * normal.z;
    alignas(bytes) Scalar lengths[lanes], inverse[lanes];
    std::memcpy(lengths, &squared, bytes);
    inverseLengths<Scalar, lanes>(lengths, inverse, smallest);
    const Vector factor = loadVector<Vector>(inverse);
    return {normal.x * factor, normal.y * factor, normal.z * factor};
  }

  MIEN_INLINE void store(int columns, int row, int column, const SurfaceRowsOutput<Scalar>& out,
                         Scalar* smallest) const {
    s.store(columns - column, out.s.at(row, column));
    unitNormals(smallest).store(columns - column, out.normal.at(row, column));
    if (out.su.first) su.store(columns - column, out.su.at(row, column));
    if (out.sv.first) sv.store(columns - column, out.sv.at(row, column));
  }
};

/// Whether all normals could be made; the others are 0.
template <class Scalar>
struct SurfaceRowsKernel {
  template <int bytes>
  static MIEN_INLINE bool run(const OperatorRows<Scalar>& u, const Scalar* uDerivative, const BoundaryPlanes<Scalar>& b,
                              const Scalar* bDerivative, const SurfaceRowsOutput<Scalar>& out) {
    constexpr int rowsAtOnce = bytes == 64 ? 2 : 1;  // nine sums a row: as many as registers hold
    constexpr int lanes = VectorOf<Scalar, bytes>::lanes;
    alignas(bytes) Scalar smallest[lanes];  // 1 / length of a normal
    std::fill_n(smallest, lanes, std::numeric_limits<Scalar>::max());
    forTiles<lanes, rowsAtOnce>(u.rows, b.columns, [&](auto rows, int row, int column) MIEN_ALWAYS {
      tile<bytes>(rows, u, uDerivative, row, b, bDerivative, column, out, smallest);
    });
    return *std::min_element(smallest, smallest + lanes) > 0;
  }

  template <int bytes, int... i>
  static MIEN_INLINE void tile(std::integer_sequence<int, i...>, const OperatorRows<Scalar>& u,
                               const Scalar* uDerivative, int row, const BoundaryPlanes<Scalar>& b,
                               const Scalar* bDerivative, int column, const SurfaceRowsOutput<Scalar>& out,
                               Scalar* smallest) {
    using Sums = SurfaceSums<Scalar, bytes>;
    using Values = Points<typename Sums::Vector>;
    const Scalar* const weights = u.first + static_cast<long>(row) * u.depth;
    const Scalar* const slopeWeights = uDerivative + static_cast<long>(row) * u.depth;
    (Values::prepareStore(out.s.at(row + i, column)), ...);
    (Values::prepareStore(out.normal.at(row + i, column)), ...);
    Sums sums[sizeof...(i)] = {};
    for (int k = 0; k < u.depth; ++k) {
      const long place = u.places[k] * b.rowStride() + column;
      const Values value = Values::load(b.first + place, b.plane), slope = Values::load(bDerivative + place, b.plane);
      (sums[i].add(weights[i * u.depth + k], slopeWeights[i * u.depth + k], value, slope), ...);
    }
    (sums[i].store(b.columns, row + i, column, out, smallest), ...);
  }
};

}  // namespace

template <class Scalar>
void vectorRows(const OperatorRows<Scalar>& u, const BoundaryPlanes<Scalar>& b, const OutputRows<Scalar>& out) {
  runOnThisProcessor<VectorRowsKernel<Scalar>, const OperatorRows<Scalar>&, const BoundaryPlanes<Scalar>&,
                     const OutputRows<Scalar>&>(u, b, out);
}

template <class Scalar>
bool surfaceRows(const OperatorRows<Scalar>& u, const Scalar* uDerivative, const BoundaryPlanes<Scalar>& b,
                 const Scalar* bDerivative, const SurfaceRowsOutput<Scalar>& out) {
  return runOnThisProcessor<SurfaceRowsKernel<Scalar>, const OperatorRows<Scalar>&, const Scalar*,
                            const BoundaryPlanes<Scalar>&, const Scalar*, const SurfaceRowsOutput<Scalar>&>(
      u, uDerivative, b, bDerivative, out);
}

template <class Scalar>
void repeatNormals(int rows, int columns, const OutputRows<Scalar>& normals) {
  for (int row = 0; row < rows; ++row) {
    const Scalar up[3] = {0, 0, 1};
    const Scalar* last = up;
    Scalar* normal = normals.at(row, 0);
    for (int column = 0; column < columns; ++column, normal += 3) {
      const Scalar size = std::abs(normal[0]) + std::abs(normal[1]) + std::abs(normal[2]);
      if (!(size > 0 && size < 2)) std::copy(last, last + 3, normal);  // also where its length is past the numbers
      last = normal;
    }
  }
}

template void vectorRows<float>(const OperatorRows<float>&, const BoundaryPlanes<float>&, const OutputRows<float>&);
template void vectorRows<double>(const OperatorRows<double>&, const BoundaryPlanes<double>&, const OutputRows<double>&);
template bool surfaceRows<float>(const OperatorRows<float>&, const float*, const BoundaryPlanes<float>&, const float*,
                                 const SurfaceRowsOutput<float>&);
template bool surfaceRows<double>(const OperatorRows<double>&, const double*, const BoundaryPlanes<double>&,
                                  const double*, const SurfaceRowsOutput<double>&);

template void repeatNormals<float>(int, int, const OutputRows<float>&);
template void repeatNormals<double>(int, int, const OutputRows<double>&);

}  // namespace mien
