#pragma once

#include <string>

#include "WarpMesh.h"

namespace mien {

/// Whole pixels of an image.
struct ImageSize {
  int width = 0, height = 0;
};

/// How far x, outside of a mesh from left to right, is on the way from the right border around the closing column to
/// the left one, 0 .. 1; 0 within the mesh.
inline double wayAround(double x, double left, double right, double width) {
  if (x >= left && x <= right) return 0.0;
  return (x > right ? x - right : x - right + width) / (width - right + left);
}

/// Two-pass mesh warping [S 4.2; Wolberg, Digital Image Warping, 1990, ch. 7]: where every pixel of a warped image
/// comes from.
///
/// The first pass resamples each row of the source image, the second each column of the result. Columns of a mesh are
/// splines x(y), rows are splines y(x), which do not overshoot (MonotoneWalk); on a line of pixels their crossings in
/// the source are taken to those in the target, monotone in between, so that a point of the source mesh goes exactly to
/// its point of the target mesh. What lies outside the target mesh repeats the colours at the mesh's border.
class MeshWarp {
 public:
  /// Meshes are scaled to their images: the source image, and the warped one.
  /// @param closed  the warped image's left and right border meet: its columns outside the target mesh go over from
  ///                those at its right border, around the closing column, to those at its left border
  /// @return nothing, or one sentence that says what is wrong, such as which rows or columns cross and where
  std::string set(const WarpMesh& source, const WarpMesh& target, ImageSize sourceSize, ImageSize warpedSize,
                  bool closed = false);

  ImageSize sourceSize() const { return sourceSize_; }
  ImageSize warpedSize() const { return warpedSize_; }

  /// For row `row` of the source image: the x in it of the borders first .. first + count - 1 of the warped image's
  /// pixels.
  void rowBorders(int row, int first, int count, double* x) const;

  /// For column `column` of the warped image: the y in the source of the borders of its pixels.
  void columnBorders(int column, int first, int count, double* y) const;

  /// From where to where the mesh reaches in row `row` of the source image, and where that is after the first pass: x
  /// in pixels.
  double firstSourceAt(int row) const { return rowSource_(row, 0); }
  double lastSourceAt(int row) const { return rowSource_(row, rowSource_.cols() - 1); }
  double firstColumnAt(int row) const { return rowTarget_(row, 0); }
  double lastColumnAt(int row) const { return rowTarget_(row, rowTarget_.cols() - 1); }

 private:
  using Knots = WarpMesh::Coordinates;

  void close(const WarpMesh& from, const WarpMesh& to);

  ImageSize sourceSize_, warpedSize_;
  Knots rowSource_, rowTarget_;        ///< source rows x mesh columns: x in the source and in the warped image
  Knots columnSource_, columnTarget_;  ///< warped columns x mesh rows: y in the source and in the warped image
};

}  // namespace mien
