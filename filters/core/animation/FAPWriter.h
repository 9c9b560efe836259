#pragma once

#include <string>

#include "FAPSequence.h"

namespace mien {

/// Writes the text format .fap (version 2.1 where the sequence has none; see FAPParser.h): a mask line and a value line
/// per frame, each number in the shortest form that reads back exactly, FAP 1 with four values and FAP 2 with six,
/// lines ending in LF. Control characters in the name become blanks, at most 1024 bytes of it are written, and a
/// sequence without a name is called "untitled", as other tools expect a word there.
/// @return nothing, or one sentence that says why it cannot be written (no frames, a number that is not finite, a frame
/// rate that is not read); the text is then as it was
std::string writeFAP(const FAPSequence& sequence, std::string& text);

/// Why no file can hold a sequence, or nothing.
std::string describeUnwritable(const FAPSequence& sequence);

/// A name as a line of text can hold it.
std::string writtenFAPName(std::string name);

}  // namespace mien
