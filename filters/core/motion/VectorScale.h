#pragma once

#include <vector>

namespace mien {

/// Round numbers for the scale of arrows and of colours, so that a figure's key can be read.
/// All take and give positive numbers.

/// The largest of 1, 2, 5 times a power of ten that is not above `number`, or the smallest that is not below it.
double roundBelow(double number);
double roundAbove(double number);  ///< as roundBelow(), from above

/// Motion per length of arrow (mm per mm): the smallest of 1, 1.2, 1.5, 2, 2.5, 3, 4 .. 9 times a power of ten that
/// draws `longest` (mm of motion) no longer than `room` (mm of arrow). 1 without motion.
double automaticScale(double longest, double room);

/// End of the colour range for magnitudes up to `largest` (mm): 1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6 or 8 times a power of
/// ten, which rangeTicks() divides evenly. 1 without motion.
double automaticRangeEnd(double largest);

/// Distance between arrows (mm on the face) that stand `printed` mm apart where 1 mm of the face is drawn `faceScale`
/// mm large, rounded up as an automatic scale is.
double automaticSpacing(double printed, double faceScale);

/// Values for the ticks of a colour bar: both ends, and between them steps of 1, 1.5, 2, 2.5, 3, 4 or 5 times a power
/// of ten with 0 among them, when such steps divide the range into at most `most` parts; else only multiples of a round
/// step that keep clear of the ends.
std::vector<double> rangeTicks(double begin, double end, int most);

}  // namespace mien
