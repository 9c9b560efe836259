#pragma once

#include <Eigen/Core>
#include <cmath>

/// Places v of grid columns, evenly around the head.
inline Eigen::VectorXd evenColumns(int count) {
  return Eigen::VectorXd::LinSpaced(count, 0.0, 2.0 * M_PI * (count - 1) / count);
}
