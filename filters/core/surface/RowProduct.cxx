#include "RowProduct.h"

#include <algorithm>
#include <cstring>

// The same few lines compiled for several processors; the right ones are chosen when the program is loaded.
// Sanitizers cannot follow that choice.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define MIEN_EVERY_PROCESSOR __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define MIEN_EVERY_PROCESSOR
#endif

namespace mien {

namespace {

constexpr int vectorBytes = 64;
constexpr int rowsAtOnce = 4;

/// A tile of one vector by a few rows: its sums stay in registers while k runs.
template <class Scalar>
inline __attribute__((always_inline)) void productOfTile(const Scalar* u, int rows, int depth, const Scalar* b,
                                                         long bStride, int columns, Scalar* out, long outStride) {
  typedef Scalar Vector __attribute__((vector_size(vectorBytes), aligned(alignof(Scalar)), may_alias));
  const Scalar* row[rowsAtOnce];
  for (int i = 0; i < rowsAtOnce; ++i) row[i] = u + static_cast<long>(std::min(i, rows - 1)) * depth;
  Vector sum[rowsAtOnce] = {};
  for (int k = 0; k < depth; ++k) {
    const Vector v = *reinterpret_cast<const Vector*>(b + k * bStride);
    for (int i = 0; i < rowsAtOnce; ++i) sum[i] += row[i][k] * v;
  }
  const bool isWhole =
      columns * sizeof(Scalar) == vectorBytes;  // a known size is one instruction, an unknown one a call
  for (int i = 0; i < std::min(rows, rowsAtOnce); ++i)
    if (isWhole)
      std::memcpy(out + i * outStride, &sum[i], vectorBytes);
    else
      std::memcpy(out + i * outStride, &sum[i], columns * sizeof(Scalar));
}

template <class Scalar>
inline __attribute__((always_inline)) void productOfTiles(const Scalar* u, int rows, int depth, const Scalar* b,
                                                          long bStride, int columns, Scalar* out, long outStride) {
  constexpr int width = vectorBytes / sizeof(Scalar);
  for (int column = 0; column < columns; column += width)
    for (int row = 0; row < rows; row += rowsAtOnce)
      productOfTile(u + static_cast<long>(row) * depth, rows - row, depth, b + column, bStride,
                    std::min(width, columns - column), out + row * outStride + column, outStride);
}

MIEN_EVERY_PROCESSOR void productOfFloats(const float* u, int rows, int depth, const float* b, long bStride,
                                          int columns, float* out, long outStride) {
  productOfTiles(u, rows, depth, b, bStride, columns, out, outStride);
}

MIEN_EVERY_PROCESSOR void productOfDoubles(const double* u, int rows, int depth, const double* b, long bStride,
                                           int columns, double* out, long outStride) {
  productOfTiles(u, rows, depth, b, bStride, columns, out, outStride);
}

}  // namespace

template <>
void rowProduct<float>(const float* u, int rows, int depth, const float* b, long bStride, int columns, float* out,
                       long outStride) {
  productOfFloats(u, rows, depth, b, bStride, columns, out, outStride);
}

template <>
void rowProduct<double>(const double* u, int rows, int depth, const double* b, long bStride, int columns, double* out,
                        long outStride) {
  productOfDoubles(u, rows, depth, b, bStride, columns, out, outStride);
}

}  // namespace mien
