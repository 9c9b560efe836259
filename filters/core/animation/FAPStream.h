#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "FAPLineParser.h"

namespace mien {

/// Reads a .fap text (FAPParser.h) that arrives in pieces of any size. A line counts once its end is there.
class FAPStream {
 public:
  /// @return what is wrong; the stream is then over
  std::optional<FAPParseError> feed(std::string_view bytes);

  /// There is no more text.
  std::optional<FAPParseError> end();

  /// The frames that are new, once the rate is known.
  std::vector<FAPFrame> takeFrames();

  const FAPSequence& sequence() const { return parser_.sequence; }  ///< name, rate, warnings; frames not taken yet

 private:
  FAPLineParser parser_;
  std::string line_;
  bool afterReturn_ = false;  ///< a line feed that follows belongs to the line before
  bool isFirst_ = true;
};

}  // namespace mien
