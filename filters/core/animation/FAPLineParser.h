#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "FAPFrameParser.h"
#include "FAPSequence.h"

namespace mien {

/// Why a text is no FAP sequence, and in which line (from 1).
struct FAPParseError {
  int line;
  std::string message;
};

/// Reads a .fap text (FAPParser.h) line by line, so that frames can be shown while more are still to come.
class FAPLineParser {
 public:
  /// One line without its ending. After an error the text is over.
  std::optional<FAPParseError> readLine(std::string_view line);

  /// There are no more lines.
  std::optional<FAPParseError> finish();

  /// What was read; the frames per second are final once rateIsKnown().
  FAPSequence sequence;

  /// Whether the header or the frame numbers have told the rate, or finish() has assumed one.
  bool rateIsKnown() const { return rateIsKnown_; }

  /// Takes the frames read since the last call out of the sequence.
  std::vector<FAPFrame> takeFrames();

 private:
  using Fault = std::string;
  enum class Expected { Header, Mask, Values };

  Fault read(std::string_view line);
  Fault readFirstLine();
  Fault readHeader();
  Fault readMask();
  Fault readValues();
  Fault describeEnd();
  void noteFrameNumber(double number);
  void checkCount();
  void takeRateFromFrameNumbers();

  Expected expected_ = Expected::Header;
  std::vector<std::string_view> entries_;
  FAPFrameParser frames_;
  std::string declaredCount_;    ///< as written
  std::vector<int> frameLines_;  ///< of the frames that were not taken yet
  int line_ = 0, headerLine_ = 0, maskLine_ = 0;
  std::int64_t frameCount_ = 0;
  double firstNumber_ = 0.0, lastNumber_ = 0.0;
  bool hasHeader_ = false, rateIsKnown_ = false, numbersIncrease_ = true;
};

}  // namespace mien
