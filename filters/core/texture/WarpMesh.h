#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace mien {

/// A mesh over an image: rows x columns points in pixels from the image's upper left corner, x to the right and y down;
/// the middle of the first pixel is (0.5, 0.5). Rows run from left to right and columns from top to bottom [S 4.2].
struct WarpMesh {
  static constexpr int largestSide = 256;  ///< rows or columns

  using Coordinates = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  double width = 0.0, height = 0.0;  ///< of the image that the points belong to, pixels
  Coordinates x, y;                  ///< rows x columns
  std::vector<std::string> names;    ///< of the points, row after row; empty, or "" for a point without one

  WarpMesh() = default;
  WarpMesh(int rows, int columns, double width, double height);

  int rows() const { return static_cast<int>(x.rows()); }
  int columns() const { return static_cast<int>(x.cols()); }

  bool operator==(const WarpMesh& other) const;
};

/// Points in equal steps from border to border.
WarpMesh evenMesh(int rows, int columns, double width, double height);

/// The same mesh over the same image of another size.
WarpMesh scaledMesh(const WarpMesh& mesh, double width, double height);

/// One sentence that says what is wrong with the mesh `name` ("the source mesh"), or nothing. A mesh whose neighbouring
/// rows or columns cross at a point is folded; crossings between points are found by MeshWarp.
std::string describeFault(const WarpMesh& mesh, const std::string& name);

}  // namespace mien
