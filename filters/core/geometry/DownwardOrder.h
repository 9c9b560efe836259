#pragma once

#include "ClosedCurves.h"

namespace mien {

/// Moves samples along y by as little as possible, in the least squares sense, so that no curve crosses the one below
/// it: isotonic regression at every v (pool adjacent violators, Ayer et al. 1955). Curves in order stay bit for bit.
///
/// It is the projection on a convex set, so curves that approximate others in order never come further from them.
void restoreDownwardOrder(ClosedCurves& curves);

}  // namespace mien
