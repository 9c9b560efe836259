#include "FoldedCells.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace mien {

namespace {

/// Cells smaller than this share of the mean have no normal worth comparing.
constexpr double degenerateShare = 1e-6;
constexpr int patchBelowMouth = 7;

/// The vector areas of all cells, stored by the row above them; between the two rows of a seam they are nothing.
class CellAreas {
 public:
  explicit CellAreas(const FaceSample& sample)
      : columns_(sample.columnCount()), areas_(sample.rowCount() * sample.columnCount()) {
    double sum = 0.0;
    for (int row = 0; row + 1 < sample.rowCount(); ++row)
      for (int column = 0; column < columns_; ++column) {
        const Eigen::Vector3d down = sample.point(row + 1, column + 1) - sample.point(row, column);
        areas_[row * columns_ + column] =
            0.5 * down.cross(sample.point(row, column + 1) - sample.point(row + 1, column));
        sum += areas_[row * columns_ + column].norm();
      }
    smallest_ = degenerateShare * sum / (sample.rowCount() * columns_);
  }

  /// Whether the normals of two cells are more than 90 degrees apart.
  bool opposed(int row, int column, int otherRow, int otherColumn) const {
    const Eigen::Vector3d& a = at(row, column);
    const Eigen::Vector3d& b = at(otherRow, otherColumn);
    return a.norm() > smallest_ && b.norm() > smallest_ && a.dot(b) < 0.0;
  }

 private:
  const Eigen::Vector3d& at(int row, int column) const {
    return areas_[row * columns_ + (column + columns_) % columns_];
  }

  int columns_;
  double smallest_ = 0.0;
  std::vector<Eigen::Vector3d> areas_;
};

/// Whether the patches above and below the seam at a patch's begin hang together at a column of cells.
bool isJoined(const FaceSample& sample, int patchBelow, int column) {
  return patchBelow != patchBelowMouth || !sample.mouth().contain(sample.v(column) + 0.5 * sample.v(1));
}

/// A cell with its folds: across edges within the patch, and across the patch's seams.
struct Folds {
  bool inside, onSeam;

  Folds(const FaceSample& sample, const CellAreas& areas, int patch, int row, int column) {
    const int begin = sample.firstRow(patch), end = sample.firstRow(patch + 1) - 1;
    const auto across = [&](int otherRow, int otherColumn) {
      return areas.opposed(row, column, otherRow, otherColumn);
    };
    inside = across(row, column - 1) || across(row, column + 1) || (row > begin && across(row - 1, column)) ||
             (row + 1 < end && across(row + 1, column));
    onSeam = (row == begin && patch > 0 && isJoined(sample, patch, column) && across(row - 2, column)) ||
             (row + 1 == end && patch + 1 < FaceLayout::patchCount && isJoined(sample, patch + 1, column) &&
              across(row + 2, column));
  }
};

Eigen::Vector3d middleOf(const FaceSample& sample, int row, int column) {
  return 0.25 * (sample.point(row, column) + sample.point(row, column + 1) + sample.point(row + 1, column) +
                 sample.point(row + 1, column + 1));
}

}  // namespace

FoldedCells::FoldedCells(const FaceSample& sample, double smallestZ) {
  const CellAreas areas(sample);
  for (int patch = 0; patch < FaceLayout::patchCount; ++patch)
    for (int row = sample.firstRow(patch); row + 1 < sample.firstRow(patch + 1); ++row)
      for (int column = 0; column < sample.columnCount(); ++column) {
        const Folds folds(sample, areas, patch, row, column);
        if (!folds.inside && !folds.onSeam) continue;
        const Eigen::Vector3d middle = middleOf(sample, row, column);
        if (middle.z() > smallestZ) cells_.push_back({patch, row, column, middle, folds.onSeam});
      }
}

int FoldedCells::countOnSeams() const {
  return static_cast<int>(std::count_if(cells_.begin(), cells_.end(), [](const Cell& cell) { return cell.onSeam; }));
}

}  // namespace mien
