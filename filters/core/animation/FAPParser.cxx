#include "FAPParser.h"

#include <utility>

#include "FAPLineParser.h"
#include "LineCutter.h"

namespace mien {

std::optional<FAPParseError> parseFAP(std::string_view text, FAPSequence& sequence) {
  if (text.size() > largestFAPText)
    return FAPParseError{1, "the file has " + std::to_string(text.size()) + " bytes; at most " +
                                std::to_string(largestFAPText) + " are read, so split it"};
  FAPLineParser parser;
  LineCutter lines(text);
  for (std::string_view line; lines.next(line);)
    if (const auto error = parser.readLine(line)) return error;
  if (const auto error = parser.finish()) return error;
  sequence = std::move(parser.sequence);
  return std::nullopt;
}

}  // namespace mien
