#include "FAPCsvParser.h"

#include <array>
#include <cmath>
#include <utility>

#include "CommaReader.h"
#include "FAPColumn.h"
#include "FAPFields.h"
#include "FAPParser.h"
#include "FrameTimes.h"
#include "MissingFrames.h"
#include "MotionBasis.h"
#include "NumberText.h"
#include "RowNumbers.h"
#include "SmallLetters.h"
#include "TimeCode.h"

namespace mien {

namespace {

constexpr std::string_view formatName = "mien fap csv ";
constexpr std::int64_t formatVersion = 1;

/// The value of "KEY=VALUE" between semicolons; the name may hold anything and comes last.
std::string_view valueOf(std::string_view comment, std::string_view key) {
  const std::size_t begin = comment.find(key);
  if (begin == comment.npos) return {};
  const std::string_view value = comment.substr(begin + key.size());
  return bareCell(key == "; name=" ? value : value.substr(0, value.find(';')));
}

class FAPCsvTextParser {
 public:
  explicit FAPCsvTextParser(std::string_view text) : reader_(text) {}
  std::optional<FAPParseError> parse();
  FAPSequence sequence;

 private:
  std::string readComment(std::string_view comment);
  std::string setOnce(std::optional<std::size_t>& place, std::size_t column) const;
  std::string bindColumns();
  std::string bindColumn(std::size_t column, const FAPColumn& fap);
  std::string readRow();
  std::string readComments();
  std::optional<FAPParseError> giveTimes();
  std::optional<FAPWarning> describeOtherTimes() const;
  std::optional<FAPParseError> error(const std::string& fault) const {
    return FAPParseError{std::max(faultLine_ > 0 ? faultLine_ : reader_.line(), 1), fault};
  }

  CommaReader reader_;
  std::vector<std::pair<std::size_t, FAPColumn>> faps_;
  std::array<std::optional<std::size_t>, FAPFrame::count + 1 + highLevelFields> seen_;  ///< the column of each
  std::optional<std::size_t> frameColumn_, timeColumn_;
  FrameTimes times_;
  int rateLine_ = 0, faultLine_ = 0;  ///< of the comment with the rate, and of one at fault
  bool hasRate_ = false, warnedOfRange_ = false;
};

std::string FAPCsvTextParser::readComment(std::string_view comment) {
  if (comment.substr(0, formatName.size()) != formatName) return {};
  const std::string_view version = comment.substr(formatName.size(), comment.find(';') - formatName.size());
  if (parseWholeNumber(bareCell(version)) != formatVersion)
    return "version " + inQuotes(bareCell(version)) + " of the table is not known; this program reads version 1";
  const std::string_view rate = valueOf(comment, "; fps=");
  const std::optional<double> number = parseNumber(rate);
  if (!rate.empty() && (!number || *number < slowestFAPRate || *number > fastestFAPRate))
    return "the frames per second are " + inQuotes(rate) + "; give a number from 0.001 to 100000";
  hasRate_ = number.has_value();
  if (hasRate_) sequence.framesPerSecond = *number;
  const std::string_view fapVersion = valueOf(comment, "; version=");
  if (fapVersion == "2.0" || fapVersion == "2.1") sequence.version = fapVersion;
  const std::string_view start = valueOf(comment, "; start=");
  const std::optional<TimeCode> code = parseTimeCode(start);
  if (!start.empty() && !code) return "the start is " + inQuotes(start) + "; write HH:MM:SS:FF, 60 frames per second";
  if (code) sequence.startTime = secondsOf(*code, writtenTimeCodeRate);
  sequence.name = valueOf(comment, "; name=");
  return {};
}

std::string FAPCsvTextParser::bindColumn(std::size_t column, const FAPColumn& fap) {
  const std::size_t place = fap.field < 0 ? fap.fap : FAPFrame::count + 1 + fap.field;
  if (seen_[place])
    return reader_.columnName(column) + " gives the FAP of " + reader_.columnName(*seen_[place]) +
           " a second time; remove one of them";
  seen_[place] = column;
  faps_.emplace_back(column, fap);
  return {};
}

std::string FAPCsvTextParser::setOnce(std::optional<std::size_t>& place, std::size_t column) const {
  if (place)
    return reader_.columnName(column) + " says again what " + reader_.columnName(*place) + " says; remove one of them";
  place = column;
  return {};
}

std::string FAPCsvTextParser::bindColumns() {
  std::vector<std::string> unused;
  const auto& header = reader_.header();
  for (std::size_t column = 0; column < header.size(); ++column) {
    std::string fault;
    const std::string small = inSmallLetters(header[column]);
    if (small == "frame")
      fault = setOnce(frameColumn_, column);
    else if (small == "time" || small == "timestamp")
      fault = setOnce(timeColumn_, column);
    else if (const auto fap = findFAPColumn(header[column]))
      fault = bindColumn(column, *fap);
    else
      unused.emplace_back(header[column]);
    if (!fault.empty()) return fault;
  }
  if (faps_.empty() && !frameColumn_)
    return "there is no column of a FAP; name them FAP3 .. FAP68, or as in MPEG-4, such as open_jaw";
  if (!unused.empty()) sequence.warnings.push_back({reader_.line(), describeUnused(unused)});
  return {};
}

std::string FAPCsvTextParser::readRow() {
  std::string fault = describeWidth(reader_);
  FAPFrame frame;
  FAPMask mask;
  frame.number = static_cast<double>(sequence.frames.size());
  if (fault.empty() && frameColumn_) frame.number = numberIn(reader_, *frameColumn_, fault).value_or(frame.number);
  if (fault.empty() && timeColumn_) {
    const std::optional<double> time = numberIn(reader_, *timeColumn_, fault);
    if (!time && fault.empty()) fault = reader_.columnName(*timeColumn_) + " is empty; give a time in s";
    times_.seconds.push_back(time.value_or(0.0));
  }
  times_.lines.push_back(reader_.line());
  for (const auto& [column, fap] : faps_) {
    if (!fault.empty()) return fault;
    const std::optional<double> value = numberIn(reader_, column, fault);
    if (!value) continue;
    if (std::abs(*value) > MotionBasis::largestValue)
      return reader_.columnName(column) + " is " + inQuotes(reader_.cells()[column]) + "; FAP values lie within +-1e6";
    fap.setValue(frame, *value);
    mask.set(fap.fap - 1);
  }
  if (limitHighLevel(frame) && !std::exchange(warnedOfRange_, true))
    sequence.warnings.push_back(
        {reader_.line(), "FAP 1 or 2 has a selection, weight or flag out of its range; it was limited"});
  sequence.frames.push_back(frame);
  sequence.masks.push_back(mask);
  return fault;
}

std::string FAPCsvTextParser::readComments() {
  for (std::size_t i = 0; i < reader_.comments().size(); ++i) {
    const bool hadRate = hasRate_;
    const std::string fault = readComment(reader_.comments()[i]);
    if (hasRate_ && !hadRate) rateLine_ = reader_.commentLine(i);
    if (fault.empty()) continue;
    faultLine_ = reader_.commentLine(i);
    return fault;
  }
  return {};
}

/// The first time that is not where the rate of the comment puts its frame.
std::optional<FAPWarning> FAPCsvTextParser::describeOtherTimes() const {
  constexpr double nearest = 0.5;  // frames; many times are rounded
  for (std::size_t i = 1; i < times_.seconds.size(); ++i) {
    const double time = times_.seconds[i] - times_.seconds[0];
    if (std::abs(time * sequence.framesPerSecond - static_cast<double>(i)) <= nearest) continue;
    return FAPWarning{times_.lines[i], reader_.columnName(*timeColumn_) + " is " + roundedText(time) +
                                           " s behind the first, but by fps=" + numberText(sequence.framesPerSecond) +
                                           " this is " + roundedText(sequence.timeOfFrame(i)) +
                                           " s; fps counts, so leave it out of line " + std::to_string(rateLine_) +
                                           " if the times are right"};
  }
  return std::nullopt;
}

std::optional<FAPParseError> FAPCsvTextParser::giveTimes() {
  sequence.rateIsAssumed = !hasRate_;
  times_.hasNumbers = frameColumn_.has_value();
  if (!hasRate_ && timeColumn_) return times_.place(sequence);
  auto warning = hasRate_ && timeColumn_ ? describeOtherTimes() : std::nullopt;
  if (!warning && frameColumn_) warning = describeMissingFrames(sequence, times_.lines);
  if (warning) sequence.warnings.push_back(*warning);
  return std::nullopt;
}

std::optional<FAPParseError> FAPCsvTextParser::parse() {
  std::string fault = reader_.readHeader();
  if (fault.empty()) fault = readComments();
  if (fault.empty()) fault = bindColumns();
  while (fault.empty() && reader_.readRow()) fault = readRow();
  if (fault.empty()) fault = reader_.fault();
  if (fault.empty() && sequence.frames.empty()) fault = "there are no frames; give a row for each below the header";
  if (!fault.empty()) return error(fault);
  if (const auto misplaced = giveTimes()) return misplaced;
  if (sequence.rateIsAssumed) sequence.warnings.push_back({1, describeAssumedRate(timeColumn_.has_value())});
  return std::nullopt;
}

}  // namespace

std::optional<FAPParseError> parseFAPCsv(std::string_view text, FAPSequence& sequence) {
  FAPCsvTextParser parser(text);
  const auto error = parser.parse();
  if (!error) sequence = std::move(parser.sequence);
  return error;
}

}  // namespace mien
