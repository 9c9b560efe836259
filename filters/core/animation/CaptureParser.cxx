#include "CaptureParser.h"

#include <algorithm>
#include <utility>

#include "CaptureColumns.h"
#include "CommaReader.h"
#include "FAPParser.h"
#include "FrameTimes.h"
#include "NumberText.h"
#include "RowNumbers.h"
#include "TimeCode.h"

namespace mien {

namespace {

constexpr double secondsPerDay = 86400.0;
constexpr double largestIntensity = 5.0, largestPercentage = 100.0;
constexpr double surelyPercent = 2.0;       // blendshapes of 0 .. 1 exceed 1 by a little at times
constexpr double tolerance = 1e-6;          // of full strength; more is limited with a warning
constexpr double timeCodeError = 1e-4;      // s; codes count thousandths of a frame
constexpr double usualTimeCodeRate = 60.0;  // of face-capture apps, when a recording is too short to tell

class Parser {
 public:
  Parser(std::string_view text, CaptureKind kind, const FacialActionMap& map)
      : text_(text), reader_(text), kind_(kind), map_(map) {}
  std::optional<FAPParseError> parse();
  FAPSequence sequence;

 private:
  CaptureColumns columnsOf(const CommaReader& reader) const;
  std::string bindColumns();
  std::string readRow();
  std::string readTime();
  std::string readStrengths(FAPFrame& frame);
  bool isLost(std::string& fault) const;
  double findFullStrength() const;
  void placeTimeCodes();
  void warn(int line, std::string message) { sequence.warnings.push_back({line, std::move(message)}); }
  std::optional<FAPParseError> finish();

  std::string_view text_;
  CommaReader reader_;
  CaptureKind kind_;
  const FacialActionMap& map_;
  CaptureColumns columns_;
  FrameTimes times_;
  std::vector<TimeCode> codes_;
  std::optional<double> face_;
  std::size_t lost_ = 0, others_ = 0;
  int firstLost_ = 0, firstOther_ = 0, headerLine_ = 0;
  bool warnedOfRange_ = false;
};

CaptureColumns Parser::columnsOf(const CommaReader& reader) const {
  return kind_ == CaptureKind::ActionUnits ? CaptureColumns::ofActionUnits(reader.header(), map_)
                                           : CaptureColumns::ofBlendshapes(reader.header(), map_);
}

std::string Parser::bindColumns() {
  headerLine_ = reader_.line();
  columns_ = columnsOf(reader_);
  if (columns_.actions == 0)
    return kind_ == CaptureKind::ActionUnits
               ? "there is no column of an action unit; name them AU1, AU2L, .. or AU01_r, .. as OpenFace does"
               : "there is no column of a blendshape; name them as ARKit does, EyeBlinkLeft or eyeBlinkLeft";
  for (const CaptureColumns::Effect& effect : columns_.effects)
    for (const CaptureColumns::Effect& other : columns_.effects)
      if (effect.column < other.column && effect.faps == other.faps && !effect.faps.empty() &&
          reader_.header()[effect.column] == reader_.header()[other.column])
        return reader_.columnName(other.column) + " is there a second time; remove one of them";
  if (!columns_.unused.empty()) warn(headerLine_, describeUnused(columns_.unused));
  const double full = findFullStrength();
  for (CaptureColumns::Effect& effect : columns_.effects)
    if (effect.full == 0.0) effect.full = full;
  return {};
}

/// Reads the table once for the largest value of the columns that do not say what their full strength is.
double Parser::findFullStrength() const {
  CommaReader reader(text_);
  double largest = 0.0;
  std::string ignored = reader.readHeader();
  while (reader.readRow())
    for (const CaptureColumns::Effect& effect : columns_.effects)
      if (effect.full == 0.0) largest = std::max(largest, numberIn(reader, effect.column, ignored).value_or(0.0));
  if (kind_ == CaptureKind::ActionUnits) return largest > 1.0 + tolerance ? largestIntensity : 1.0;
  return largest > surelyPercent ? largestPercentage : 1.0;
}

/// Whether the face was lost in this row, or it belongs to another face.
bool Parser::isLost(std::string& fault) const {
  for (const auto& flag : {columns_.success, columns_.shapeCount})
    if (flag && numberIn(reader_, *flag, fault) == 0.0) return true;
  const auto isEmpty = [&](const CaptureColumns::Effect& effect) {
    return effect.column >= reader_.cells().size() || reader_.cells()[effect.column].empty();
  };
  return std::all_of(columns_.effects.begin(), columns_.effects.end(), isEmpty);
}

std::string Parser::readTime() {
  std::string fault;
  if (columns_.timeCode) {
    const auto& cells = reader_.cells();
    const std::string_view cell = *columns_.timeCode < cells.size() ? cells[*columns_.timeCode] : std::string_view();
    const std::optional<TimeCode> code = parseTimeCode(cell);
    if (!code)
      return reader_.columnName(*columns_.timeCode) + " is " + inQuotes(cell) + "; write HH:MM:SS:FF or HH:MM:SS.sss";
    codes_.push_back(*code);
  } else if (columns_.time) {
    const std::optional<double> time = numberIn(reader_, *columns_.time, fault);
    if (!time) return fault.empty() ? reader_.columnName(*columns_.time) + " is empty; give a time in s" : fault;
    times_.seconds.push_back(*time);
  }
  times_.lines.push_back(reader_.line());
  return fault;
}

std::string Parser::readStrengths(FAPFrame& frame) {
  std::string fault;
  for (const CaptureColumns::Effect& effect : columns_.effects) {
    const std::optional<double> value = numberIn(reader_, effect.column, fault);
    if (!fault.empty()) return fault;
    if (!value) return reader_.columnName(effect.column) + " is empty; give a number, or leave the whole row empty";
    const double strength = effect.isAngle ? *value : std::clamp(*value / effect.full, 0.0, 1.0);
    if (std::abs(strength - *value / effect.full) > tolerance && !std::exchange(warnedOfRange_, true))
      warn(reader_.line(), reader_.columnName(effect.column) + " is outside 0 .. " + std::to_string(int(effect.full)) +
                               "; such values are limited");
    for (const auto& [fap, full] : effect.faps) frame.setValue(fap, frame.value(fap) + strength * full);
  }
  return {};
}

std::string Parser::readRow() {
  std::string fault;
  if (columns_.face) {
    const std::optional<double> face = numberIn(reader_, *columns_.face, fault);
    if (!face_) face_ = face;
    if (face != face_) {
      if (others_++ == 0) firstOther_ = reader_.line();
      return fault;
    }
  }
  if (isLost(fault)) {
    if (lost_++ == 0) firstLost_ = reader_.line();
    const bool hasTime = columns_.time || columns_.timeCode;
    if (!hasTime && !sequence.frames.empty()) sequence.frames.push_back(sequence.frames.back());
    return fault;
  }
  if (fault.empty()) fault = describeWidth(reader_);
  if (fault.empty()) fault = readTime();
  FAPFrame frame;
  frame.number = static_cast<double>(sequence.frames.size());
  if (fault.empty() && columns_.frame) frame.number = numberIn(reader_, *columns_.frame, fault).value_or(frame.number);
  if (fault.empty()) fault = readStrengths(frame);
  sequence.frames.push_back(frame);
  return fault;
}

/// The usual step of codes within a second, in frames; 1 when there is none. A quarter of the steps may be shorter and
/// most may be gaps.
double stepOf(const std::vector<TimeCode>& codes) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < codes.size(); ++i)
    if (codes[i].seconds == codes[i - 1].seconds && codes[i].frames > codes[i - 1].frames)
      steps.push_back(codes[i].frames - codes[i - 1].frames);
  if (steps.empty()) return 1.0;
  std::nth_element(steps.begin(), steps.begin() + steps.size() / 4, steps.end());
  return steps[steps.size() / 4];
}

/// How many frames make a second, by the codes before and after its end; 0 when none follow each other there.
double countOfSecond(const std::vector<TimeCode>& codes) {
  const double step = stepOf(codes);
  double count = 0.0;
  for (std::size_t i = 1; i < codes.size(); ++i)
    if (codes[i].seconds == codes[i - 1].seconds + 1.0 && codes[i].frames < step)
      count = std::max(count, codes[i - 1].frames - codes[i].frames + step);
  return count;
}

/// Gives the times of the codes; their frames per second follow from the largest frame, when a second is complete.
void Parser::placeTimeCodes() {
  const bool hasFrames = std::any_of(codes_.begin(), codes_.end(), [](const TimeCode& code) { return code.hasFrames; });
  const bool complete = codes_.front().seconds != codes_.back().seconds;
  double largest = countOfSecond(codes_) - 1.0;
  for (const TimeCode& code : codes_) largest = std::max(largest, code.frames);
  if (hasFrames && !complete && codes_.size() > 1) {
    largest = std::max(largest, usualTimeCodeRate - 1.0);
    warn(times_.lines.front(), "the time codes do not pass a full second; they are taken as 60 frames per second");
  }
  const double rate = rateOfTimeCodes(largest, codes_.front().dropsNumbers);
  if (hasFrames) times_.clockError = timeCodeError;
  double midnights = 0.0;
  for (const TimeCode& code : codes_) {
    double time = secondsOf(code, rate) + midnights;
    if (!times_.seconds.empty() && times_.seconds.back() - time > secondsPerDay / 2.0) {
      midnights += secondsPerDay;
      time += secondsPerDay;
    }
    times_.seconds.push_back(time);
  }
}

std::optional<FAPParseError> Parser::finish() {
  if (others_ > 0)
    warn(firstOther_, std::to_string(others_) + " rows of other faces are left out; the first face is used");
  if (lost_ > 0) warn(firstLost_, std::to_string(lost_) + " rows without a face are bridged");
  FAPMask mask;
  for (const CaptureColumns::Effect& effect : columns_.effects)
    for (const auto& [fap, value] : effect.faps) mask.set(fap - 1);
  sequence.masks.assign(sequence.frames.size(), mask);
  sequence.rateIsAssumed = true;
  if (!codes_.empty()) placeTimeCodes();
  if (const auto error = times_.place(sequence)) return error;
  if (sequence.rateIsAssumed) warn(headerLine_, "there is no time; 25 frames per second are assumed");
  return std::nullopt;
}

std::optional<FAPParseError> Parser::parse() {
  std::string fault = reader_.readHeader();
  if (fault.empty()) fault = bindColumns();
  while (fault.empty() && reader_.readRow()) fault = readRow();
  if (fault.empty()) fault = reader_.fault();
  if (fault.empty() && sequence.frames.empty()) fault = "there are no frames; give a row for each below the header";
  if (!fault.empty()) return FAPParseError{std::max(reader_.line(), 1), fault};
  return finish();
}

}  // namespace

std::optional<FAPParseError> parseCapture(std::string_view text, CaptureKind kind, const FacialActionMap& map,
                                          FAPSequence& sequence) {
  Parser parser(text, kind, map);
  const auto error = parser.parse();
  if (!error) sequence = std::move(parser.sequence);
  return error;
}

}  // namespace mien
