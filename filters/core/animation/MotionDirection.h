#pragma once

#include <Eigen/Core>

#include "FAPTable.h"

namespace mien {

/// A unit vector of the face (x to its left, y up, z forward), or 0 for what is no shift.
inline Eigen::Vector3d motionDirection(FAPDirection direction) {
  switch (direction) {
    case FAPDirection::Left:
      return {1.0, 0.0, 0.0};
    case FAPDirection::Right:
      return {-1.0, 0.0, 0.0};
    case FAPDirection::Up:
      return {0.0, 1.0, 0.0};
    case FAPDirection::Down:
      return {0.0, -1.0, 0.0};
    case FAPDirection::Forward:
      return {0.0, 0.0, 1.0};
    default:
      return {0.0, 0.0, 0.0};
  }
}

}  // namespace mien
