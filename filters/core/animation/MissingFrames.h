#pragma once

#include <optional>
#include <vector>

#include "FAPSequence.h"

namespace mien {

/// Whether frame numbers leave some out: they grow, and by more in some places than in others, or evenly by more than 1
/// without being milliseconds of the rate.
bool framesAreMissing(const FAPSequence& sequence);

/// Says which frames of a file are missing, as those that are there play one after the other.
///
/// @param lines where the frames stand in the file; nothing is said where there are not as many
std::optional<FAPWarning> describeMissingFrames(const FAPSequence& sequence, const std::vector<int>& lines);

}  // namespace mien
