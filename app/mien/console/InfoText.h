#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace mien {

/// A line of a description on stdout: the label, and the text in a column of its own.
void printLine(const std::string& label, const std::string& text);

/// The items of a list with blanks between, or "none".
std::string joined(const nlohmann::ordered_json& list);

/// "12.34".
std::string twoDigits(double value);

}  // namespace mien
