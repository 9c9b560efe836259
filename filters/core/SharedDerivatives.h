#pragma once

#include <Eigen/Core>

namespace mien {

/// The u-derivatives that neighbouring patches share at their curves, as combinations of the 29 curves
/// (29 x 29, per unit of a patch's u; neighbouring curves are 1/3 apart).
///
/// Differences in curve index, centred inside a chain of curves and one-sided at its ends. At the mouth
/// the surface is the sum of a surface through one chain of 28 curves, with the mean of C22 and C22' at
/// the lip line, and one of two chains that hold -+(C22' - C22)/2 there and 0 elsewhere: the closed
/// mouth is as smooth as any seam, and the lips part cleanly.
///
/// @param order  1: S_u, 2: S_uu
Eigen::MatrixXd sharedDerivatives(int order);

}  // namespace mien
