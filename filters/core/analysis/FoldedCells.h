#pragma once

#include <vector>

#include "FaceSample.h"

namespace mien {

/// Cells of a face's grid whose normal is turned by more than 90 degrees against that of a cell across one of their
/// edges.
///
/// A cell without area, as between closed lids, has no normal and is not compared; nor are the two sides of the slit
/// between the mouth corners, which is an opening.
class FoldedCells {
 public:
  static constexpr double frontalZ = 50.0;  ///< mm; only cells whose middle lies beyond are counted

  /// One folded cell.
  struct Cell {
    int patch, row, column;  ///< row of the sample above the cell
    Eigen::Vector3d middle;  ///< mm
    bool onSeam;             ///< folded across an edge that lies on a seam
  };

  explicit FoldedCells(const FaceSample& sample, double smallestZ = frontalZ);

  const std::vector<Cell>& cells() const { return cells_; }
  int count() const { return static_cast<int>(cells_.size()); }
  int countOnSeams() const;

 private:
  std::vector<Cell> cells_;
};

}  // namespace mien
