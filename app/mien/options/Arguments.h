#pragma once

#include <string>
#include <utility>
#include <vector>

namespace mien {

/// Reading the values of options. Each throws a ValueFailure that names the option, its value and what is allowed.

/// A check for options: what is wrong with an empty value, or nothing.
std::string isNotEmpty(const std::string& text);

/// A finite number, in the C locale whatever the user's is.
double parseNumber(const std::string& option, const std::string& text);

/// A whole number.
int parseWholeNumber(const std::string& option, const std::string& text);

/// A length above 0: "0.1mm" or "0.1".
double parseMillimetres(const std::string& option, const std::string& text);

/// The parts between separators; an empty text has one empty part.
std::vector<std::string> splitText(const std::string& text, char separator);

/// "56x40": two whole numbers from 1 up.
std::pair<int, int> parseSize(const std::string& option, const std::string& text);

}  // namespace mien
