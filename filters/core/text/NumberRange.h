#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mien {

/// Reads a list of numbers and ranges separated by commas: "1,2,5", "0.1:1:10" (ten numbers from 0.1 to 1, equally
/// spaced), "0.1:100:50log" (fifty, each the same factor larger), "0.5,1:4:7".
///
/// @param numbers  in the order of the text; unchanged when there is a fault
/// @return one sentence that says which part cannot be read and what is allowed, or nothing
std::string parseNumberRange(std::string_view text, std::vector<double>& numbers);

}  // namespace mien
