#pragma once

#include <algorithm>
#include <cstring>
#include <utility>

// Kernels are compiled for several processors from the same lines. Sanitizers and fuzzers need only one of them.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define MIEN_SEVERAL_PROCESSORS
#endif

#define MIEN_ALWAYS __attribute__((always_inline))
#define MIEN_INLINE inline MIEN_ALWAYS

namespace mien {

/// As many numbers as `bytes` hold, computed at once.
template <class Scalar, int bytes>
struct VectorOf;

#define MIEN_VECTOR(Scalar, bytes)                                         \
  template <>                                                              \
  struct VectorOf<Scalar, bytes> {                                         \
    static constexpr int lanes = bytes / static_cast<int>(sizeof(Scalar)); \
    typedef Scalar Type __attribute__((vector_size(bytes)));               \
  };
MIEN_VECTOR(float, 16)
MIEN_VECTOR(float, 32)
MIEN_VECTOR(float, 64)
MIEN_VECTOR(double, 16)
MIEN_VECTOR(double, 32)
MIEN_VECTOR(double, 64)
#undef MIEN_VECTOR

/// A vector of the numbers from `first` on.
template <class Vector, class Scalar>
MIEN_INLINE Vector loadVector(const Scalar* first) {
  Vector vector;
  std::memcpy(&vector, first, sizeof(Vector));
  return vector;
}

/// The first `count` numbers of a vector; a known number of them is one instruction, an unknown one a call. By value: a
/// vector whose address is taken would not stay in a register.
template <int lanes, class Vector, class Scalar>
MIEN_INLINE void storeSome(Vector vector, int count, Scalar* out) {
  if (count >= lanes) {
    std::memcpy(out, &vector, lanes * sizeof(Scalar));
  } else if (count > 0) {
    const Vector copy = vector;
    std::memcpy(out, &copy, count * sizeof(Scalar));
  }
}

/// Columns at once: their part of B stays in the first cache while rows run, and rows are written in long pieces.
constexpr int columnsAtOnce = 64;

/// tile(0, 1, ... of the rows at once, first row, first column) for all rows and columns; its arrays by row are then
/// known to the compiler, and stay in registers.
template <int lanes, int rowsAtOnce, class Tile>
MIEN_INLINE void forTiles(int rows, int columns, const Tile& tile) {
  for (int begin = 0; begin < columns; begin += columnsAtOnce) {
    const int end = std::min(columns, begin + columnsAtOnce);
    int row = 0;
    for (; row + rowsAtOnce <= rows; row += rowsAtOnce)
      for (int column = begin; column < end; column += lanes)
        tile(std::make_integer_sequence<int, rowsAtOnce>(), row, column);
    for (; row < rows; ++row)
      for (int column = begin; column < end; column += lanes) tile(std::integer_sequence<int, 0>(), row, column);
  }
}

#ifdef MIEN_SEVERAL_PROCESSORS
/// Kernel::run<bytes>(arguments) compiled for one kind of processor.
template <class Kernel, class... Arguments>
__attribute__((target("arch=x86-64-v4,prefer-vector-width=512"))) auto runWithAVX512(Arguments... arguments) {
  return Kernel::template run<64>(arguments...);
}
template <class Kernel, class... Arguments>
__attribute__((target("arch=x86-64-v3"))) auto runWithAVX2(Arguments... arguments) {
  return Kernel::template run<32>(arguments...);
}
#endif
/// Kernel::run<bytes>(arguments) for any processor.
template <class Kernel, class... Arguments>
auto runAnywhere(Arguments... arguments) {
  return Kernel::template run<16>(arguments...);
}

/// Kernel::run<bytes>(arguments) with the longest vectors that this processor has; run must be MIEN_INLINE.
template <class Kernel, class... Arguments>
auto runOnThisProcessor(Arguments... arguments) {
#ifdef MIEN_SEVERAL_PROCESSORS
  static const auto run = __builtin_cpu_supports("x86-64-v4")   ? runWithAVX512<Kernel, Arguments...>
                          : __builtin_cpu_supports("x86-64-v3") ? runWithAVX2<Kernel, Arguments...>
                                                                : runAnywhere<Kernel, Arguments...>;
  return run(arguments...);
#else
  return runAnywhere<Kernel>(arguments...);
#endif
}

}  // namespace mien
