#pragma once

namespace mien {

/// From here on Ctrl-C and a request to end are only noted, so that a long command can stop between two files. A second
/// one ends the program at once.
void noteInterruptions();

bool wasInterrupted();

}  // namespace mien
