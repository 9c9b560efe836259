#pragma once

#include <map>
#include <string>

namespace mien {

/// What options say about the movement of a face. Each throws a ValueFailure that names the option and what is wrong;
/// spaces around names and values do not count.

/// "joy:0.6, surprise:0.4": names and intensities, 1 without one. Whether there are such expressions is not looked at.
std::map<std::string, double> parseExpressions(const std::string& option, const std::string& text);

/// "p_b_m" or "10:0.7,U": one viseme or two by name, blanks written as such or as _, or by their number 1 .. 14 in
/// FAP 1. A single one without a strength is at 1; of two, one without gets what the other leaves, as b and 63 - b of
/// FAP 1, and both without are at a half.
std::map<std::string, double> parseVisemes(const std::string& option, const std::string& text);

/// "53=200,FAP54=200,open_jaw=300": low-level FAPs by number or name (FAPColumn.h).
std::map<int, double> parseFAPValues(const std::string& option, const std::string& text);

}  // namespace mien
