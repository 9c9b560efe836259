#pragma once

#include <string>
#include <vector>

namespace mien {

/// A table by name or file, and the factor on its displacements.
struct WeightedName {
  std::string name;
  double weight = 1.0;
};

constexpr double largestTableWeight = 2.0;  ///< either sign

/// "joy", "joy:0.5", "joy:0.5,tables/anna.csv:-1": names with weights -2 .. 2, 1 without one; several add up. A colon
/// before a slash belongs to the file.
/// @return nothing, or one sentence that says what is wrong
std::string parseTableList(const std::string& text, std::vector<WeightedName>& tables);

}  // namespace mien
