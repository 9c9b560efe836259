#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "FaceLayout.h"

namespace mien {

/// The u-derivative of that order at every curve of a chain, as combinations of the chain's curves (n x n,
/// per unit of a patch's u; neighbouring curves are 1/3 apart).
///
/// @param order  1: S_u, 2: S_uu
/// @param rates  of the harmonic in each of the n - 1 intervals between curves
using ChainDerivatives = Eigen::MatrixXd (*)(int order, const std::vector<double>& rates);

/// Differences in curve index, centred inside the chain and one-sided at its ends; the same for all rates.
Eigen::MatrixXd differenceDerivatives(int order, const std::vector<double>& rates);

/// The slopes with which pieces of order 4 between neighbouring curves have continuous S_uu, and S_uu = 0 at
/// the ends of the chain: one tridiagonal system. (order 1 only)
Eigen::MatrixXd splineDerivatives(int order, const std::vector<double>& rates);

/// The u-derivatives that neighbouring pieces share at their curves, as combinations of the 29 curves (29 x 29).
///
/// At the mouth the surface is the sum of one through a single chain of 28 curves, with the mean of C22 and
/// C22' at the lip line, and one of two chains that hold -+(C22' - C22)/2 there and 0 elsewhere: the closed
/// mouth is as smooth as any seam, and the lips part cleanly.
///
/// @param rates  of the harmonic in each patch
Eigen::MatrixXd sharedDerivatives(ChainDerivatives rule, int order,
                                  const std::array<double, FaceLayout::patchCount>& rates);

}  // namespace mien
