#pragma once

#include "FaceState.h"

#include <string>
#include <vector>

namespace mien {

struct FAPSequence;

/// One moment of an animation to show.
struct AnimationFrame {
  FaceState::FrameChoice choice = FaceState::FrameChoice::Index;
  double value = 0.0;   ///< an index or a time, as the choice says
  double time = 0.0;    ///< s from the first frame of the file
  std::string caption;  ///< frame number as written, and time
};

/// The frames from FIRST to LAST, numbers as written in the file, either may be left out; all without a range. With a
/// rate the moments are 1 / rate apart and mixed from the frames around them; without one (0) they are the frames.
/// Throws a ValueFailure for a range that is none or holds no frame.
std::vector<AnimationFrame> chooseFrames(const FAPSequence& sequence, const std::string& range, double rate);

}  // namespace mien
