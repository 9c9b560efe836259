#pragma once

namespace mien {

/// The next of 1, 2, 5, 10 .. that is not smaller, for the end of a scale of values from 0 up.
double roundedUp(double value);

}  // namespace mien
