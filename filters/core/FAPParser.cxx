#include "FAPParser.h"

#include <algorithm>
#include <utility>

#include "FAPFrameParser.h"
#include "NumberText.h"

namespace mien {

namespace {

constexpr double assumedRate = 25.0;                // frames per second without a header
constexpr double smallestMillisecondStep = 10.0;    // frame numbers that step by less count frames
constexpr std::size_t fewestEntriesLikeAMask = 20;  // a first line of this many digits is a mask, not a header
constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

using Fault = std::string;

/// Takes the lines off a text one by one; they end in LF, CR LF or CR.
class LineCutter {
 public:
  explicit LineCutter(std::string_view text) : rest_(text) {}
  bool next(std::string_view& line) {
    if (rest_.empty()) return false;
    const auto isEnd = [](char c) { return c == '\r' || c == '\n'; };
    const std::size_t end = std::find_if(rest_.begin(), rest_.end(), isEnd) - rest_.begin();
    line = rest_.substr(0, end);
    const std::size_t ending = rest_.substr(end, 2) == "\r\n" ? 2 : 1;
    rest_.remove_prefix(std::min(end + ending, rest_.size()));
    ++number_;
    return true;
  }
  int number() const { return number_; }

 private:
  std::string_view rest_;
  int number_ = 0;
};

bool looksLikeAMask(const std::vector<std::string_view>& entries) {
  const auto isDigit = [](std::string_view entry) { return entry.size() == 1 && entry[0] >= '0' && entry[0] <= '9'; };
  return entries.size() >= fewestEntriesLikeAMask && std::all_of(entries.begin(), entries.end(), isDigit);
}

Fault readVersion(std::string_view entry) {
  const std::optional<double> version = parseNumber(entry);
  if (version == 2.0 || version == 2.1) return {};
  return "version " + inQuotes(entry) + " is not a face animation this reads; the header begins with 2.0 or 2.1";
}

Fault readRate(std::string_view entry, double& rate) {
  const std::optional<double> number = parseNumber(entry);
  if (!number || *number < slowestFAPRate || *number > fastestFAPRate)
    return "the frames per second are " + inQuotes(entry) + "; give a number from 0.001 to 100000";
  rate = *number;
  return {};
}

/// What stands between the version and the last two entries, blanks inside kept.
std::string nameBetween(const std::vector<std::string_view>& entries) {
  if (entries.size() < 4) return {};
  const std::string_view first = entries[1], last = entries[entries.size() - 3];
  return std::string(first.data(), last.data() + last.size());
}

class Parser {
 public:
  std::optional<FAPParseError> parse(std::string_view text);
  FAPSequence sequence;

 private:
  enum class Expected { Header, Mask, Values };

  Fault readLine(std::string_view line);
  Fault readFirstLine();
  Fault readHeader();
  Fault readMask();
  Fault readValues();
  Fault finish();
  void checkCount();
  void takeRateFromFrameNumbers();
  void checkFrameNumbers();

  Expected expected_ = Expected::Header;
  std::vector<std::string_view> entries_;
  FAPFrameParser frames_;
  std::vector<int> valueLines_;
  int line_ = 0;
  int headerLine_ = 0, maskLine_ = 0;
  bool hasHeader_ = false;
};

std::optional<FAPParseError> Parser::parse(std::string_view text) {
  if (text.substr(0, byteOrderMark.size()) == byteOrderMark) text.remove_prefix(byteOrderMark.size());
  LineCutter lines(text);
  for (std::string_view line; lines.next(line);) {
    line_ = lines.number();
    const Fault fault = readLine(line);
    if (!fault.empty()) return FAPParseError{line_, fault};
  }
  const Fault fault = finish();
  if (!fault.empty()) return FAPParseError{std::max(line_, 1), fault};
  return std::nullopt;
}

Fault Parser::readLine(std::string_view line) {
  if (line.find('\0') != line.npos) return "there is a NUL byte; a .fap file is plain text";
  const std::size_t begin = line.find_first_not_of(" \t\v\f");
  if (begin == line.npos || line[begin] == '#') return {};
  if (line.size() > longestFAPLine)
    return "the line has " + std::to_string(line.size()) + " bytes; at most " + std::to_string(longestFAPLine) +
           " are read";
  splitAtBlanks(line, entries_);
  if (expected_ == Expected::Header) return readFirstLine();
  return expected_ == Expected::Mask ? readMask() : readValues();
}

Fault Parser::readFirstLine() {
  headerLine_ = line_;
  expected_ = Expected::Mask;
  if (looksLikeAMask(entries_)) return readMask();
  if (entries_.size() == 1 && parseWholeNumber(entries_[0])) return {};
  return readHeader();
}

Fault Parser::readHeader() {
  hasHeader_ = true;
  if (entries_.size() < 3) return "the header is incomplete; it is VERSION NAME FRAMES_PER_SECOND FRAME_COUNT";
  const std::string_view count = entries_.back();
  Fault fault = readVersion(entries_.front());
  if (fault.empty()) fault = readRate(entries_[entries_.size() - 2], sequence.framesPerSecond);
  sequence.declaredFrameCount = parseWholeNumber(count);
  if (fault.empty() && !sequence.declaredFrameCount)
    fault = "the frame count is " + inQuotes(count) + "; give a whole number";
  sequence.version = entries_.front();
  sequence.name = nameBetween(entries_);
  return fault;
}

Fault Parser::readMask() {
  maskLine_ = line_;
  expected_ = Expected::Values;
  return frames_.readMask(entries_, line_, sequence);
}

Fault Parser::readValues() {
  expected_ = Expected::Mask;
  valueLines_.push_back(line_);
  return frames_.readValues(entries_, line_, sequence);
}

Fault Parser::finish() {
  if (expected_ == Expected::Values) {
    line_ = maskLine_;
    return "this mask has no line of values after it; the file may have been cut off";
  }
  if (sequence.frames.empty()) return "there are no frames; a .fap file has a header, then mask and value lines";
  if (hasHeader_)
    checkCount();
  else
    takeRateFromFrameNumbers();
  checkFrameNumbers();
  const auto earlier = [](const FAPWarning& a, const FAPWarning& b) { return a.line < b.line; };
  std::stable_sort(sequence.warnings.begin(), sequence.warnings.end(), earlier);
  return {};
}

void Parser::checkCount() {
  const std::int64_t declared = *sequence.declaredFrameCount, found = static_cast<std::int64_t>(sequence.frames.size());
  if (declared != found)
    sequence.warnings.push_back({headerLine_, "the header says " + std::to_string(declared) + " frames, there are " +
                                                  std::to_string(found) + "; all of these are used"});
}

void Parser::takeRateFromFrameNumbers() {
  const auto& frames = sequence.frames;
  const double step = frames.size() > 1 ? frames[1].number - frames[0].number : 0.0;
  const bool milliseconds = step >= smallestMillisecondStep && step <= 1000.0 / slowestFAPRate;
  sequence.framesPerSecond = milliseconds ? 1000.0 / step : assumedRate;
  std::string message = "there is no header; ";
  appendNumber(message, sequence.framesPerSecond);
  message += " frames per second are ";
  message += milliseconds ? "taken from the frame numbers, which are milliseconds" : "assumed";
  sequence.warnings.push_back({headerLine_, message});
}

void Parser::checkFrameNumbers() {
  const auto notAfter = [](const FAPFrame& a, const FAPFrame& b) { return !(b.number > a.number); };
  const auto& frames = sequence.frames;
  const auto found = std::adjacent_find(frames.begin(), frames.end(), notAfter);
  if (found == frames.end()) return;
  const std::size_t index = static_cast<std::size_t>(found - frames.begin()) + 1;
  sequence.warnings.push_back(
      {valueLines_[index], "the frame number is not larger than the one before; frames play in the order of the file"});
}

}  // namespace

std::optional<FAPParseError> parseFAP(std::string_view text, FAPSequence& sequence) {
  if (text.size() > largestFAPText)
    return FAPParseError{1, "the file has " + std::to_string(text.size()) + " bytes; at most " +
                                std::to_string(largestFAPText) + " are read, so split it"};
  Parser parser;
  std::optional<FAPParseError> error = parser.parse(text);
  if (!error) sequence = std::move(parser.sequence);
  return error;
}

}  // namespace mien
