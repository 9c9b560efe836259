#pragma once

#include <string>
#include <vector>

#include "ClosedCurves.h"

namespace mien {

/// For every curve: at how many places, eight for every sample, it lies more than 0.1 mm below the next one.
std::vector<int> crossingsBelow(const ClosedCurves& curves);

/// The curves of a face that cross, such as "C3 and C4 (12 places), C4 and C5 (1 place)", or nothing.
std::string namedCrossings(const ClosedCurves& curves);

}  // namespace mien
