#include "CaptureParser.h"

#include <algorithm>
#include <utility>

#include "CaptureColumns.h"
#include "CommaReader.h"
#include "Counted.h"
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
constexpr double leastPercentage = 5.0;     // that one of them reaches when they are per cent
constexpr double tellingShare = 0.2;        // of the cells that are not 0
constexpr double largestAngle = 10.0;       // rad; more than a turn is no pose of a head
constexpr double strengthTolerance = 1e-6;  // of full strength; more is limited with a warning
constexpr double timeCodeError = 1e-4;      // s; codes count thousandths of a frame
constexpr double usualTimeCodeRate = 60.0;  // of face-capture apps, when a recording is too short to tell

class CaptureTextParser {
 public:
  CaptureTextParser(std::string_view text, CaptureKind kind, const FacialActionMap& map)
      : text_(text), reader_(text), kind_(kind), map_(map) {}
  std::optional<FAPParseError> parse();
  FAPSequence sequence;

 private:
  CaptureColumns columnsOf(const CommaReader& reader) const;
  std::string bindColumns();
  std::string readRow();
  std::string readTime();
  double frameNumber(std::string& fault) const;
  std::string readStrengths(FAPFrame& frame);
  bool isLost(std::string& fault) const;
  struct Strengths {
    std::vector<double> largest;        ///< per effect
    std::vector<double> above, moving;  ///< cells above the usual full strength, and not 0
  };
  Strengths survey() const;
  double findFullStrength(const Strengths& strengths);
  void dropStandIns(const Strengths& strengths);
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
  std::size_t lost_ = 0, lostBefore_ = 0, others_ = 0;
  int firstLost_ = 0, firstOther_ = 0, headerLine_ = 0;
  bool warnedOfRange_ = false;
};

CaptureColumns CaptureTextParser::columnsOf(const CommaReader& reader) const {
  return kind_ == CaptureKind::ActionUnits ? CaptureColumns::ofActionUnits(reader.header(), map_)
                                           : CaptureColumns::ofBlendshapes(reader.header(), map_);
}

std::string CaptureTextParser::bindColumns() {
  headerLine_ = reader_.line();
  columns_ = columnsOf(reader_);
  if (columns_.actions == 0)
    return kind_ == CaptureKind::ActionUnits
               ? "there is no column of an action unit; name them AU1, AU2L, .. or AU01_r, .. as OpenFace does"
               : "there is no column of a blendshape; name them as ARKit does, EyeBlinkLeft or eyeBlinkLeft";
  if (!columns_.fault.empty()) return columns_.fault;
  const Strengths strengths = survey();
  const double full = findFullStrength(strengths);
  for (CaptureColumns::Effect& effect : columns_.effects)
    if (effect.full == 0.0) effect.full = full;
  dropStandIns(strengths);
  if (!columns_.unused.empty()) warn(headerLine_, describeUnused(columns_.unused));
  return {};
}

/// Reads the table once for what the columns reach.
CaptureTextParser::Strengths CaptureTextParser::survey() const {
  const std::size_t count = columns_.effects.size();
  Strengths strengths{std::vector<double>(count), std::vector<double>(count), std::vector<double>(count)};
  const double usual = kind_ == CaptureKind::ActionUnits ? 1.0 + strengthTolerance : surelyPercent;
  CommaReader reader(text_);
  std::string ignored = reader.readHeader();
  while (reader.readRow())
    for (std::size_t i = 0; i < count; ++i) {
      const double value = std::abs(numberIn(reader, columns_.effects[i].column, ignored).value_or(0.0));
      strengths.largest[i] = std::max(strengths.largest[i], value);
      strengths.above[i] += value > usual;
      strengths.moving[i] += value > 0.0;
    }
  return strengths;
}

/// The full strength of columns that do not say theirs. A single cell beyond 1 is a slip of the tracking: it takes most
/// of the moving columns, or a good share of the cells, to tell another scale.
double CaptureTextParser::findFullStrength(const Strengths& strengths) {
  double largest = 0.0, above = 0.0, moving = 0.0, columnsAbove = 0.0, columnsMoving = 0.0;
  for (std::size_t i = 0; i < columns_.effects.size(); ++i) {
    if (columns_.effects[i].full != 0.0) continue;
    largest = std::max(largest, strengths.largest[i]);
    above += strengths.above[i];
    moving += strengths.moving[i];
    columnsAbove += strengths.above[i] > 0.0;
    columnsMoving += strengths.moving[i] > 0.0;
  }
  const bool units = kind_ == CaptureKind::ActionUnits;
  const bool many =
      2.0 * columnsAbove > columnsMoving || above > tellingShare * moving || (units && columnsAbove >= 3.0);
  if (!many || largest <= (units ? 1.0 + strengthTolerance : leastPercentage)) return 1.0;
  warn(headerLine_, units ? "values go beyond 1; action units are taken as intensities 0 .. 5"
                          : "values go far beyond 1; blendshapes are taken as per cent, 0 .. 100");
  return units ? largestIntensity : largestPercentage;
}

/// Rotations of the eyes repeat what the eyeLook shapes say, whose direction their names tell: these count where they
/// move at all.
void CaptureTextParser::dropStandIns(const Strengths& strengths) {
  std::vector<CaptureColumns::Effect> kept;
  FAPMask moved;
  for (std::size_t i = 0; i < columns_.effects.size(); ++i)
    for (const auto& [fap, value] : columns_.effects[i].faps)
      if (!columns_.effects[i].standsIn && strengths.moving[i] > 0.0) moved.set(fap - 1);
  for (std::size_t i = 0; i < columns_.effects.size(); ++i) {
    const CaptureColumns::Effect& effect = columns_.effects[i];
    const bool idle = effect.standsIn && !effect.faps.empty() && moved[effect.faps.front().first - 1];
    const bool useless = effect.faps.empty() && effect.isAngle;
    if (useless && strengths.moving[i] > 0.0) columns_.unused.emplace_back(reader_.header()[effect.column]);
    if (!idle && !useless) kept.push_back(effect);
  }
  columns_.effects = std::move(kept);
}

/// Whether the face was lost in this row, or it belongs to another face.
bool CaptureTextParser::isLost(std::string& fault) const {
  for (const auto& flag : {columns_.success, columns_.shapeCount})
    if (flag && numberIn(reader_, *flag, fault) == 0.0) return true;
  const auto isEmpty = [&](const CaptureColumns::Effect& effect) {
    return effect.column >= reader_.cells().size() || reader_.cells()[effect.column].empty();
  };
  return std::all_of(columns_.effects.begin(), columns_.effects.end(), isEmpty);
}

std::string CaptureTextParser::readTime() {
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
  times_.lostBefore.push_back(static_cast<int>(lost_ - lostBefore_));
  lostBefore_ = lost_;
  return fault;
}

std::string CaptureTextParser::readStrengths(FAPFrame& frame) {
  std::string fault;
  for (const CaptureColumns::Effect& effect : columns_.effects) {
    const std::optional<double> value = numberIn(reader_, effect.column, fault);
    if (!fault.empty()) return fault;
    if (!value) return reader_.columnName(effect.column) + " is empty; give a number, or leave the whole row empty";
    if (effect.isAngle && std::abs(*value) > largestAngle)
      return reader_.columnName(effect.column) + " is " + inQuotes(reader_.cells()[effect.column]) +
             "; give an angle in rad, within +-10";
    const double strength = effect.isAngle ? *value : std::clamp(*value / effect.full, 0.0, 1.0);
    if (std::abs(strength - *value / effect.full) > strengthTolerance && !std::exchange(warnedOfRange_, true))
      warn(reader_.line(), reader_.columnName(effect.column) + " is outside 0 .. " + std::to_string(int(effect.full)) +
                               "; such values are limited");
    for (const auto& [fap, full] : effect.faps) frame.setValue(fap, frame.value(fap) + strength * full);
  }
  return {};
}

double CaptureTextParser::frameNumber(std::string& fault) const {
  const double counted = static_cast<double>(sequence.frames.size());
  return columns_.frame ? numberIn(reader_, *columns_.frame, fault).value_or(counted) : counted;
}

std::string CaptureTextParser::readRow() {
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
    if (!hasTime && !sequence.frames.empty()) {
      sequence.frames.push_back(sequence.frames.back());
      sequence.frames.back().number = frameNumber(fault);
    }
    return fault;
  }
  if (fault.empty()) fault = describeWidth(reader_);
  if (fault.empty()) fault = readTime();
  FAPFrame frame;
  if (fault.empty()) frame.number = frameNumber(fault);
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
void CaptureTextParser::placeTimeCodes() {
  const bool hasFrames = std::any_of(codes_.begin(), codes_.end(), [](const TimeCode& code) { return code.hasFrames; });
  const bool complete = codes_.front().seconds != codes_.back().seconds;
  double largest = countOfSecond(codes_) - 1.0;
  for (const TimeCode& code : codes_) largest = std::max(largest, code.frames);
  if (hasFrames && !complete) {
    largest = std::max(largest, usualTimeCodeRate - 1.0);
    warn(times_.lines.front(), "the time codes do not pass a full second; they are taken as 60 frames per second");
  }
  const double rate = rateOfTimeCodes(largest, codes_.front().dropsNumbers);
  if (hasFrames) times_.clockError = timeCodeError;
  if (hasFrames) times_.clockRate = rate;
  if (hasFrames) sequence.framesPerSecond = rate;  // unless the times tell another
  if (hasFrames) sequence.rateIsAssumed = false;
  sequence.startTime = secondsOf(codes_.front(), rate);
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

std::optional<FAPParseError> CaptureTextParser::finish() {
  if (others_ > 0) warn(firstOther_, counted(others_, "row") + " of other faces left out; the first face is used");
  if (lost_ > 0) warn(firstLost_, counted(lost_, "row") + " without a face bridged");
  FAPMask mask;
  for (const CaptureColumns::Effect& effect : columns_.effects)
    for (const auto& [fap, value] : effect.faps) mask.set(fap - 1);
  sequence.masks.assign(sequence.frames.size(), mask);
  sequence.rateIsAssumed = true;
  times_.hasNumbers = columns_.frame.has_value();
  if (!codes_.empty()) placeTimeCodes();
  if (const auto error = times_.place(sequence)) return error;
  if (sequence.rateIsAssumed) warn(headerLine_, describeAssumedRate(!times_.seconds.empty()));
  return std::nullopt;
}

std::optional<FAPParseError> CaptureTextParser::parse() {
  std::string fault = reader_.readHeader();
  if (fault.empty()) fault = bindColumns();
  while (fault.empty() && reader_.readRow()) fault = readRow();
  if (fault.empty()) fault = reader_.fault();
  if (fault.empty() && sequence.frames.empty())
    fault = lost_ > 0 ? "no face was found in any row (success or blendshape count is 0, or the cells are empty)"
                      : "there are no frames; give a row for each below the header";
  if (!fault.empty()) return FAPParseError{std::max(reader_.line(), 1), fault};
  return finish();
}

}  // namespace

std::optional<FAPParseError> parseCapture(std::string_view text, CaptureKind kind, const FacialActionMap& map,
                                          FAPSequence& sequence) {
  CaptureTextParser parser(text, kind, map);
  const auto error = parser.parse();
  if (!error) sequence = std::move(parser.sequence);
  return error;
}

}  // namespace mien
