#include "RowProduct.h"

#include "ProcessorVectors.h"

namespace mien {

namespace {

/// Tiles of one vector by a few rows: their sums stay in registers while k runs.
template <class Scalar>
struct RowProductKernel {
  template <int bytes>
  static MIEN_INLINE void run(const Scalar* u, int rows, int depth, const Scalar* b, long bStride, int columns,
                              Scalar* out, long outStride) {
    constexpr int rowsAtOnce = 8;
    forTiles<VectorOf<Scalar, bytes>::lanes, rowsAtOnce>(
        rows, columns, [&](auto some, int row, int column) MIEN_ALWAYS {
          tile<typename VectorOf<Scalar, bytes>::Type>(some, u + static_cast<long>(row) * depth, depth, b + column,
                                                       bStride, columns - column, out + row * outStride + column,
                                                       outStride);
        });
  }

  template <class Vector, int... i>
  static MIEN_INLINE void tile(std::integer_sequence<int, i...>, const Scalar* u, int depth, const Scalar* b,
                               long bStride, int columns, Scalar* out, long outStride) {
    Vector sums[sizeof...(i)] = {};
    for (int k = 0; k < depth; ++k) {
      const Vector v = loadVector<Vector>(b + k * bStride);
      ((sums[i] += u[i * depth + k] * v), ...);
    }
    (storeSome<sizeof(Vector) / sizeof(Scalar)>(sums[i], columns, out + i * outStride), ...);
  }
};

}  // namespace

template <class Scalar>
void rowProduct(const Scalar* u, int rows, int depth, const Scalar* b, long bStride, int columns, Scalar* out,
                long outStride) {
  runOnThisProcessor<RowProductKernel<Scalar>>(u, rows, depth, b, bStride, columns, out, outStride);
}

template void rowProduct<float>(const float*, int, int, const float*, long, int, float*, long);
template void rowProduct<double>(const double*, int, int, const double*, long, int, double*, long);

}  // namespace mien
