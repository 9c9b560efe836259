#pragma once

#include <memory>
#include <string>
#include <vector>

#include "FAPFrame.h"
#include "MienAnimationModule.h"

namespace mien {

struct FAPSequence;

/// A .fap stream that is still being written, such as standard input. Not for two threads at once.
class MIENANIMATION_EXPORT FAPLiveInput {
 public:
  /// Open: more may come; Ended: the last frame has come; Failed: it cannot be read, or is no .fap.
  enum class State { Open, Ended, Failed };

  /// @param descriptor an open file to read; it stays open
  explicit FAPLiveInput(int descriptor = 0);
  ~FAPLiveInput();
  FAPLiveInput(const FAPLiveInput&) = delete;
  FAPLiveInput& operator=(const FAPLiveInput&) = delete;

  /// Waits until something has come, at most so long, and appends the frames that are complete.
  State wait(int milliseconds, std::vector<FAPFrame>& frames);

  /// Name, rate and warnings as far as they are known; complete frames are not in it.
  const FAPSequence& sequence() const;

  /// When State::Failed: "standard input:LINE: what is wrong and what to do".
  const std::string& fault() const;

 private:
  struct Internals;
  std::unique_ptr<Internals> Impl;
};

}  // namespace mien
