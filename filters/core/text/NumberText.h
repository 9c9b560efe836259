#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

/// A finite decimal number that fills the whole text, with a dot whatever the locale; a leading + is allowed. One too
/// small to hold becomes 0.
std::optional<double> parseNumber(std::string_view text);

/// What a decimal number is that std::from_chars called out of range: 0 where it is too small to hold, else infinite.
double outOfRangeNumber(std::string_view text);

/// A whole number that fills the whole text; one too large to hold becomes the largest (smallest) there is.
std::optional<std::int64_t> parseWholeNumber(std::string_view text);

/// Appends the shortest text that parseNumber turns back into exactly this finite number.
void appendNumber(std::string& text, double number);

/// That text alone.
std::string numberText(double number);

/// The number to three significant digits, for messages.
std::string roundedText(double number);

/// The parts of a line between blanks and tabs, in `parts`, whose memory is used again.
void splitAtBlanks(std::string_view line, std::vector<std::string_view>& parts);

/// Text from a file as it can stand in a message: in single quotes, shortened, control characters replaced by '?'.
std::string inQuotes(std::string_view text);

}  // namespace mien
