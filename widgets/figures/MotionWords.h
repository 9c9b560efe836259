#pragma once

#include <string>

#include "MotionVectorOptions.h"

namespace mien {

/// What a figure of motion vectors shows, in words.
struct MotionWords {
  std::string moved;   ///< "joy", "frame 120 of talk.fap"; empty: a face at rest
  std::string origin;  ///< "the neutral face", "frame 100"
  std::string view;    ///< "front", "45\u00b0"
  std::string made;    ///< of what, and with which parameters: the first part of the note
  bool headMotionRemoved = false;

  std::string title() const;  ///< "Joy against the neutral face"
};

/// Gives a figure its title, its caption and its note, of which the sampling is left to the figure itself.
void describeMotion(const MotionWords& words, MotionVectorOptions& options);

}  // namespace mien
