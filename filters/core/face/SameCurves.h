#pragma once

#include "ClosedCurves.h"

namespace mien {

/// Whether both are the same curves: no coordinate differs by more than a file in single precision or another
/// processor's rounding makes (0.001 mm; scans are a hundred times coarser).
bool areSameCurves(const ClosedCurves& one, const ClosedCurves& other);

}  // namespace mien
