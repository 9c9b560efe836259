#pragma once

#include <string>

#include "FAPSequence.h"

namespace mien {

/// Writes the table of FAPCsvParser.h: `frame`, `time` (s) and a column for each FAP that a frame sets, ten for FAP 1
/// and 2; a FAP that a frame does not set is an empty cell, so that the table reads back to the same frames and masks.
/// @return nothing, or one sentence that says why it cannot be written (no frames, a number that is not finite); the
/// text is then as it was
std::string writeFAPCsv(const FAPSequence& sequence, std::string& text);

}  // namespace mien
