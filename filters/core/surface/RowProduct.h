#pragma once

namespace mien {

/// As many numbers as the longest vector holds: so many can be read behind the end of B.
constexpr int rowProductPadding = 16;

/// out = U B, row-major: out(row, column) = sum over k, in this order, of u(row, k) b(k, column).
///
/// Every element is summed in the same order wherever it stands, so a part of a grid has the bits of the
/// whole, and a closing column those of the first. The library's product does not promise that.
///
/// @param u          rows x depth, contiguous
/// @param b          depth x columns, rows `bStride` apart; rowProductPadding numbers behind the last can be read
/// @param outStride  distance of the rows of out
template <class Scalar>
void rowProduct(const Scalar* u, int rows, int depth, const Scalar* b, long bStride, int columns, Scalar* out,
                long outStride);

}  // namespace mien
