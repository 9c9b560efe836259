#pragma once

#include <string>

namespace mien {

/// Numbers with as many decimals as their standard deviation makes worth reading: one significant digit of the
/// deviation, two where it begins with 1; at most `mostDecimals`. No text reads -0.
constexpr int mostDecimals = 6;

/// "0.123(4)", which stands for 0.123 +- 0.004; "3.2(1.4)" for deviations of 1 and more.
std::string conciseText(double value, double deviation);

/// "0.123" and "0.004" joined by the sign: "0.123+-0.004".
std::string rangeText(double value, double deviation, const std::string& sign);

/// A number without a deviation: three decimals, more where it would have fewer than two significant digits and they
/// are not 0.
std::string fixedText(double value);

}  // namespace mien
