#pragma once

namespace mien {

/// One boundary condition of a patch: the u-derivative of that order equals a closed curve at u.
struct Condition {
  double u = 0.0;      ///< where, in the patch's own u, 0 .. 1
  int derivative = 0;  ///< 0: the surface itself, 1: S_u, 2: S_uu
  int curve = 0;       ///< which row of the boundary data gives the value
};

}  // namespace mien
