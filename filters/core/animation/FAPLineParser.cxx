#include "FAPLineParser.h"

#include <algorithm>

#include "FAPParser.h"
#include "MissingFrames.h"
#include "NumberText.h"

namespace mien {

namespace {

constexpr double assumedRate = 25.0;                // frames per second without a header
constexpr double smallestMillisecondStep = 10.0;    // frame numbers that step by less count frames
constexpr std::size_t fewestEntriesLikeAMask = 20;  // a first line of this many digits is a mask, not a header

using Fault = std::string;

bool looksLikeAMask(const std::vector<std::string_view>& entries) {
  const auto isDigit = [](std::string_view entry) { return entry.size() == 1 && entry[0] >= '0' && entry[0] <= '9'; };
  return entries.size() >= fewestEntriesLikeAMask && std::all_of(entries.begin(), entries.end(), isDigit);
}

/// The name in a header may hold a #, so a comment begins there only behind the two numbers that end it.
void leaveOutComment(std::vector<std::string_view>& entries) {
  constexpr std::size_t leastEntries = 3;  // version, rate and count
  const auto endsAt = [&](std::size_t count) {
    return count >= leastEntries && parseNumber(entries[count - 1]) && parseNumber(entries[count - 2]);
  };
  for (std::size_t i = leastEntries; i < entries.size(); ++i)
    if (entries[i].front() == '#' && endsAt(i)) return entries.resize(i);
  if (entries.size() > 1 && entries[1].front() == '#' && !endsAt(entries.size())) entries.resize(1);
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

}  // namespace

std::optional<FAPParseError> FAPLineParser::readLine(std::string_view line) {
  ++line_;
  const Fault fault = read(line);
  if (!fault.empty()) return FAPParseError{line_, fault};
  return std::nullopt;
}

std::optional<FAPParseError> FAPLineParser::finish() {
  const Fault fault = describeEnd();
  if (!fault.empty()) return FAPParseError{std::max(line_, 1), fault};
  if (hasHeader_) checkCount();
  if (!rateIsKnown_) takeRateFromFrameNumbers();
  if (const auto missing = describeMissingFrames(sequence, frameLines_)) sequence.warnings.push_back(*missing);
  const auto earlier = [](const FAPWarning& a, const FAPWarning& b) { return a.line < b.line; };
  std::stable_sort(sequence.warnings.begin(), sequence.warnings.end(), earlier);
  return std::nullopt;
}

std::vector<FAPFrame> FAPLineParser::takeFrames() {
  std::vector<FAPFrame> taken;
  taken.swap(sequence.frames);
  sequence.masks.clear();
  frameLines_.clear();
  return taken;
}

FAPLineParser::Fault FAPLineParser::read(std::string_view line) {
  if (line.find('\0') != line.npos) return "there is a NUL byte; a .fap file is plain text";
  const std::size_t begin = line.find_first_not_of(" \t\v\f");
  if (begin == line.npos || line[begin] == '#') return {};
  if (line.size() > longestFAPLine)
    return "the line has " + std::to_string(line.size()) + " bytes; at most " + std::to_string(longestFAPLine) +
           " are read";
  splitAtBlanks(expected_ == Expected::Header ? line : line.substr(0, line.find('#')), entries_);
  if (expected_ == Expected::Header) return readFirstLine();
  return expected_ == Expected::Mask ? readMask() : readValues();
}

FAPLineParser::Fault FAPLineParser::readFirstLine() {
  headerLine_ = line_;
  expected_ = Expected::Mask;
  leaveOutComment(entries_);
  if (looksLikeAMask(entries_)) return readMask();
  if (entries_.size() == 1 && parseWholeNumber(entries_[0])) return {};
  return readHeader();
}

FAPLineParser::Fault FAPLineParser::readHeader() {
  hasHeader_ = rateIsKnown_ = true;
  if (!parseNumber(entries_.front())) return "not a .fap file: line 1 must read like `2.1 name 25 108`";
  if (entries_.size() < 3) return "the header is incomplete; it is VERSION NAME FRAMES_PER_SECOND FRAME_COUNT";
  const std::string_view count = entries_.back();
  Fault fault = readVersion(entries_.front());
  if (fault.empty()) fault = readRate(entries_[entries_.size() - 2], sequence.framesPerSecond);
  sequence.declaredFrameCount = parseWholeNumber(count);
  declaredCount_ = count;
  if (fault.empty() && !sequence.declaredFrameCount)
    fault = "the frame count is " + inQuotes(count) + "; give a whole number";
  sequence.version = entries_.front();
  sequence.name = nameBetween(entries_);
  return fault;
}

FAPLineParser::Fault FAPLineParser::readMask() {
  maskLine_ = line_;
  expected_ = Expected::Values;
  return frames_.readMask(entries_, line_, sequence);
}

FAPLineParser::Fault FAPLineParser::readValues() {
  expected_ = Expected::Mask;
  const Fault fault = frames_.readValues(entries_, line_, sequence);
  if (fault.empty()) noteFrameNumber(sequence.frames.back().number);
  return fault;
}

void FAPLineParser::noteFrameNumber(double number) {
  ++frameCount_;
  frameLines_.push_back(line_);
  if (frameCount_ == 1) firstNumber_ = number;
  if (frameCount_ > 1 && numbersIncrease_ && !(number > lastNumber_)) {
    numbersIncrease_ = false;
    sequence.warnings.push_back(
        {line_, "the frame number is not larger than the one before; frames play in the order of the file"});
  }
  lastNumber_ = number;
  if (frameCount_ == 2 && !rateIsKnown_) takeRateFromFrameNumbers();
}

FAPLineParser::Fault FAPLineParser::describeEnd() {
  if (expected_ == Expected::Values) {
    line_ = maskLine_;
    return "this mask has no line of values after it; the file may have been cut off";
  }
  if (frameCount_ == 0) return "there are no frames; a .fap file has a header, then mask and value lines";
  return {};
}

void FAPLineParser::checkCount() {
  const std::int64_t declared = *sequence.declaredFrameCount;
  if (declared != frameCount_)
    sequence.warnings.push_back({headerLine_, "the header says " + declaredCount_ + " frames, there are " +
                                                  std::to_string(frameCount_) + "; all of these are used"});
}

/// Called with the second frame, or at the end of a text of one.
void FAPLineParser::takeRateFromFrameNumbers() {
  const double step = lastNumber_ - firstNumber_;
  const bool milliseconds = step >= smallestMillisecondStep && step <= 1000.0 / slowestFAPRate;
  sequence.framesPerSecond = milliseconds ? 1000.0 / step : assumedRate;
  sequence.rateIsAssumed = !milliseconds;
  rateIsKnown_ = true;
  std::string message = "there is no header; ";
  appendNumber(message, sequence.framesPerSecond);
  message += " frames per second are ";
  message += milliseconds ? "taken from the frame numbers, which are milliseconds" : "assumed";
  sequence.warnings.push_back({headerLine_, message});
}

}  // namespace mien
