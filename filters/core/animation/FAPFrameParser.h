#pragma once

#include <bitset>
#include <string>
#include <string_view>
#include <vector>

#include "FAPSequence.h"

namespace mien {

/// Brings the fields of FAP 1 and 2 into their ranges: selections 0 .. 14 and 0 .. 6 (others select nothing), weights
/// 0 .. 63, flags 0 or 1. @return whether something was out of range
bool limitHighLevel(FAPFrame& frame);

/// Reads the mask and value lines of a .fap file, entry by entry, and appends their frames; see FAPParser.h.
class FAPFrameParser {
 public:
  /// @return nothing, or one sentence that says what is wrong
  std::string readMask(const std::vector<std::string_view>& entries, int line, FAPSequence& sequence);

  /// Appends the frame and the mask read before it. @return nothing, or one sentence that says what is wrong
  std::string readValues(const std::vector<std::string_view>& entries, int line, FAPSequence& sequence);

 private:
  static constexpr std::size_t longMask = FAPFrame::count + 1;  ///< some writers add an entry without meaning
  enum Quirk { LongMask, SingleValues, OutOfRange, Absurd, quirkCount };

  std::string parseNumbers(const std::vector<std::string_view>& entries);
  void warnOnce(Quirk quirk, int line, const std::string& message, FAPSequence& sequence);
  bool readHighLevel(bool singleValues, FAPFrame& frame);
  double takeValue(int fap, int line, FAPSequence& sequence);
  double take() { return numbers_[next_++]; }

  std::bitset<longMask> mask_;
  std::vector<double> numbers_;
  std::size_t next_ = 0;
  std::bitset<quirkCount> warned_;
};

}  // namespace mien
