#pragma once

#include <vector>

namespace mien {

/// Round numbers for the scale of arrows and of colours, so that a figure's key can be read.
/// All take and give positive numbers.

/// The largest of 1, 2, 5 times a power of ten that is not above `number`, or the smallest that is not below it.
double roundBelow(double number);
double roundAbove(double number);

/// Motion per length of arrow (mm per mm): the smallest of 1, 1.2, 1.5, 2, 2.5, 3, 4 .. 9 times a power of ten that
/// draws `longest` (mm of motion) no longer than `room` (mm of arrow). 1 without motion.
double automaticScale(double longest, double room);

/// End of the colour range for magnitudes up to `largest` (mm), of the same round numbers. 1 without motion.
double automaticRangeEnd(double largest);

}  // namespace mien
