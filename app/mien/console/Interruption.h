#pragma once

namespace mien {

/// From here on Ctrl-C and a request to end are only noted, so that a long command can stop between two files. A second
/// one ends the program at once.
void noteInterruptions();

bool wasInterrupted();

/// After an interruption: from here on a second one is only noted too, for a command that still has something to keep.
/// A third one ends the program at once.
void noteSecondInterruption();

bool wasInterruptedTwice();

}  // namespace mien
