#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "FAPLineParser.h"
#include "FAPSequence.h"

namespace mien {

constexpr std::size_t largestFAPText = std::size_t{256} << 20;       ///< bytes; about a million frames
constexpr std::size_t longestFAPLine = std::size_t{64} << 10;        ///< bytes; a line of numbers needs less than 3,000
constexpr double slowestFAPRate = 0.001, fastestFAPRate = 100000.0;  ///< frames per second that are accepted

/// Reads the text format .fap of MPEG-4 face animation:
///
///     # comments, in lines of their own or behind the entries of another
///     VERSION NAME FPS COUNT           2.0 or 2.1; the name may have blanks
///     MASK                             68 times 0 or 1
///     FRAME VALUE VALUE ...            one value per 1 of the mask; FAP 1 has four, FAP 2 six
///
/// mask and value lines alternating. The frames that are there count, not COUNT. Accepted with a warning: a header
/// that disagrees; no header, or a single whole number for one (25 frames per second, or 1000 / S where frame numbers
/// step by S >= 10 ms); masks of 69 entries; FAP 1 and 2 written as one value each; selections and weights of FAP 1
/// and 2 out of their ranges; frame numbers that do not increase or leave some out (MissingFrames.h); values beyond
/// 1e6, which are limited. Each kind is warned of once, at its first line. Everything else is refused.
///
/// @return the error, and then `sequence` is as it was; or nothing
std::optional<FAPParseError> parseFAP(std::string_view text, FAPSequence& sequence);

}  // namespace mien
