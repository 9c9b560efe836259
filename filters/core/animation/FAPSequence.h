#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "FAPFrame.h"

namespace mien {

/// Which FAPs a frame sets; bit n - 1 stands for FAP n.
using FAPMask = std::bitset<FAPFrame::count>;

/// Something in a file that was accepted but should be known.
struct FAPWarning {
  int line;  ///< from 1
  std::string message;
};

/// An animation: frames at a constant rate, frame i (from 0) at i / framesPerSecond seconds.
struct FAPSequence {
  std::string version;  ///< "2.0" or "2.1" as written; empty when the file has no header
  std::string name;
  double framesPerSecond = 25.0;
  bool rateIsAssumed = false;                      ///< the file does not say how fast it plays
  double startTime = 0.0;                          ///< s since midnight of the first frame by its time code; 0 for none
  std::optional<std::int64_t> declaredFrameCount;  ///< what the header says; the frames themselves are what counts
  std::vector<FAPFrame> frames;
  std::vector<FAPMask> masks;  ///< as written, one per frame, or none for frames of other origin
  std::vector<FAPWarning> warnings;

  FAPMask mask(std::size_t index) const;  ///< what this frame sets: by its mask, or by not being 0
  std::vector<int> fapsUsed() const;      ///< the FAPs that at least one frame sets, ascending
  std::vector<int> fapsMoved() const;     ///< those that at least one frame gives a value other than 0

  double timeOfFrame(std::size_t index) const { return index / framesPerSecond; }  ///< s
  double duration() const;                                                         ///< s, time of the last frame

  /// The first frame that carries this number in the file.
  std::optional<std::size_t> indexOfNumber(double number) const;

  /// The frame at or before a time (s), kept within the sequence; there must be a frame. A time that falls short of a
  /// frame by less than a millionth of the frame interval counts as that frame, so that sums of intervals find theirs.
  std::size_t indexAtTime(double time) const;

  /// The frame at or before a time (s), or between two frames their linear mixture; there must be a frame. Visemes and
  /// expressions are mixed by their weights; where the frames select more than two, those of the frame before stay.
  FAPFrame frameAtTime(double time, bool interpolate) const;
};

}  // namespace mien
