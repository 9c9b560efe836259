#pragma once

#include <Eigen/Core>
#include <vector>

namespace mien {

/// The nearest of many points, by a balanced k-d tree [Friedman, Bentley and Finkel 1977]. Safe to ask from several
/// threads.
class PointTree {
 public:
  using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

  /// Keeps a copy of the points; rows that are not finite are never found.
  explicit PointTree(const Points& points);

  /// The row of the nearest point that lies nearer than `reach`, or -1.
  int nearest(const Eigen::RowVector3d& place, double reach) const;

 private:
  struct Search;
  void build(int begin, int end);
  void descend(int begin, int end, Search& search) const;

  Points points_;
  std::vector<int> order_;         ///< rows; the middle of every range divides it
  std::vector<signed char> axis_;  ///< by which coordinate, at the position of the middle
};

}  // namespace mien
