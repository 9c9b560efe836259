#include "PointTree.h"

#include <algorithm>

namespace mien {

namespace {

constexpr int pointsPerLeaf = 8;

}  // namespace

struct PointTree::Search {
  const Eigen::RowVector3d& place;
  double squared;
  int found = -1;
};

PointTree::PointTree(const Points& points) : points_(points), axis_(static_cast<size_t>(points.rows()), 0) {
  for (int i = 0; i < points.rows(); ++i)
    if (points.row(i).allFinite()) order_.push_back(i);
  build(0, static_cast<int>(order_.size()));
}

void PointTree::build(int begin, int end) {
  if (end - begin <= pointsPerLeaf) return;
  Eigen::RowVector3d low = points_.row(order_[begin]), high = low;
  for (int i = begin + 1; i < end; ++i) {
    low = low.cwiseMin(points_.row(order_[i]));
    high = high.cwiseMax(points_.row(order_[i]));
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const int middle = (begin + end) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](int a, int b) { return points_(a, axis) < points_(b, axis); });
  axis_[middle] = static_cast<signed char>(axis);
  build(begin, middle);
  build(middle + 1, end);
}

void PointTree::descend(int begin, int end, Search& search) const {
  const auto look = [&](int i) {
    const double squared = (points_.row(order_[i]) - search.place).squaredNorm();
    if (squared >= search.squared) return;
    search.squared = squared;
    search.found = order_[i];
  };
  if (end - begin <= pointsPerLeaf) {
    for (int i = begin; i < end; ++i) look(i);
    return;
  }
  const int middle = (begin + end) / 2, axis = axis_[middle];
  const double side = search.place[axis] - points_(order_[middle], axis);
  look(middle);
  side < 0.0 ? descend(begin, middle, search) : descend(middle + 1, end, search);
  if (side * side >= search.squared) return;
  side < 0.0 ? descend(middle + 1, end, search) : descend(begin, middle, search);
}

int PointTree::nearest(const Eigen::RowVector3d& place, double reach) const {
  Search search{place, reach * reach};
  descend(0, static_cast<int>(order_.size()), search);
  return search.found;
}

}  // namespace mien
