#pragma once

#include <Eigen/Core>

#include "FAPTable.h"

/// Where a positive value of a FAP moves its feature point, as a unit vector of the face (x to its left, y up).
inline Eigen::Vector3d fapAxis(int fap) {
  switch (mien::fapDefinition(fap).positiveMotion) {
    case mien::FAPDirection::Left:
      return {1, 0, 0};
    case mien::FAPDirection::Right:
      return {-1, 0, 0};
    case mien::FAPDirection::Up:
      return {0, 1, 0};
    case mien::FAPDirection::Forward:
      return {0, 0, 1};
    default:
      return {0, -1, 0};
  }
}
