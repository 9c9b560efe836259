#pragma once

#include <string>
#include <vector>

#include "FaceState.h"

namespace mien {

struct FAPSequence;
struct FrameOptions;

/// One moment of an animation to show.
struct AnimationFrame {
  FaceState::FrameChoice choice = FaceState::FrameChoice::Index;
  double value = 0.0;   ///< an index or a time, as the choice says
  double time = 0.0;    ///< s from the first frame of the file; repetitions go on
  std::string caption;  ///< frame number as written, and time
  std::string number;   ///< as written; empty for a moment between frames
};

/// The frames that the options choose: from FIRST to LAST, numbers as written in the file, and within --start and
/// --end; all without. With a rate the moments are 1 / rate apart and mixed from the frames around them; without one
/// they are the frames. Repetitions follow after one step. Throws a ValueFailure for options that are wrong or leave no
/// frame.
std::vector<AnimationFrame> chooseFrames(const FAPSequence& sequence, const FrameOptions& options);

/// Frames per second of what chooseFrames gives.
double rateOf(const FAPSequence& sequence, const FrameOptions& options);

}  // namespace mien
