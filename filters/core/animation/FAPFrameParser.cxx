#include "FAPFrameParser.h"

#include <algorithm>
#include <cmath>

#include "MotionBasis.h"
#include "NumberText.h"

namespace mien {

namespace {

constexpr double largestViseme = 14.0, largestExpression = 6.0;
constexpr std::size_t visemeValues = 4, expressionValues = 6;

/// Brings the fields of FAP 1 and 2 into their ranges and remembers whether one had to be changed.
class Limiter {
 public:
  void selection(double& value, double largest) {
    const bool exists = value >= 0.0 && value <= largest && value == std::floor(value);
    set(value, exists ? value : 0.0);  // what does not exist selects nothing
  }
  void weight(double& value) { set(value, std::clamp(value, 0.0, FAPFrame::fullWeight)); }
  void flag(double& value) { set(value, value == 0.0 ? 0.0 : 1.0); }

  bool changed = false;

 private:
  void set(double& value, double limited) {
    changed = changed || value != limited;
    value = limited;
  }
};

}  // namespace

bool limitHighLevel(FAPFrame& frame) {
  Viseme& v = frame.viseme;
  Expression& e = frame.expression;
  Limiter limiter;
  for (double* selection : {&v.select1, &v.select2}) limiter.selection(*selection, largestViseme);
  for (double* selection : {&e.select1, &e.select2}) limiter.selection(*selection, largestExpression);
  for (double* weight : {&v.blend, &e.intensity1, &e.intensity2}) limiter.weight(*weight);
  for (double* flag : {&v.definition, &e.initialFace, &e.definition}) limiter.flag(*flag);
  return limiter.changed;
}

namespace {

std::string countFault(std::size_t found, std::size_t expected) {
  return "there are " + std::to_string(found) + " numbers; the mask before asks for " + std::to_string(expected) +
         ", the frame number included";
}

}  // namespace

void FAPFrameParser::warnOnce(Quirk quirk, int line, const std::string& message, FAPSequence& sequence) {
  if (!warned_[quirk]) sequence.warnings.push_back({line, message});
  warned_.set(quirk);
}

std::string FAPFrameParser::readMask(const std::vector<std::string_view>& entries, int line, FAPSequence& sequence) {
  if (entries.size() != FAPFrame::count && entries.size() != longMask)
    return "the mask has " + std::to_string(entries.size()) + " entries; it must have 68, one for each FAP";
  for (std::size_t i = 0; i < entries.size(); ++i)
    if (entries[i] != "0" && entries[i] != "1")
      return "mask entry " + std::to_string(i + 1) + " is " + inQuotes(entries[i]) + "; it must be 0 or 1";
  mask_.reset();
  for (std::size_t i = 0; i < entries.size(); ++i) mask_[i] = entries[i] == "1";
  if (entries.size() == longMask)
    warnOnce(LongMask, line, "the mask has 69 entries; the last and its values are left out", sequence);
  return {};
}

std::string FAPFrameParser::parseNumbers(const std::vector<std::string_view>& entries) {
  numbers_.clear();
  next_ = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::optional<double> number = parseNumber(entries[i]);
    if (!number)
      return "entry " + std::to_string(i + 1) + " is " + inQuotes(entries[i]) + "; it must be a finite number";
    numbers_.push_back(*number);
  }
  return {};
}

std::string FAPFrameParser::readValues(const std::vector<std::string_view>& entries, int line, FAPSequence& sequence) {
  const std::size_t single = 1 + mask_.count();
  const std::size_t full = single + mask_[0] * (visemeValues - 1) + mask_[1] * (expressionValues - 1);
  if (entries.size() != full && entries.size() != single) return countFault(entries.size(), full);
  const std::string fault = parseNumbers(entries);
  if (!fault.empty()) return fault;
  FAPFrame frame;
  frame.number = take();
  if (readHighLevel(entries.size() != full, frame))
    warnOnce(OutOfRange, line, "FAP 1 or 2 has a selection, weight or flag out of its range; it was limited", sequence);
  for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count; ++fap)
    if (mask_[fap - 1]) frame.setValue(fap, takeValue(fap, line, sequence));
  if (entries.size() != full)
    warnOnce(SingleValues, line, "FAP 1 and 2 have one value each; it is taken as a selection at full weight",
             sequence);
  sequence.frames.push_back(frame);
  sequence.masks.emplace_back(mask_.to_string().substr(longMask - FAPFrame::count));
  return {};
}

/// The animator would limit it unseen, and a table of FAPs could not hold it.
double FAPFrameParser::takeValue(int fap, int line, FAPSequence& sequence) {
  constexpr double largest = MotionBasis::largestValue;
  const double value = take();
  if (std::abs(value) > largest)
    warnOnce(
        Absurd, line,
        "FAP " + std::to_string(fap) + " is " + numberText(value) + "; FAP values lie within +-1e6, it was limited",
        sequence);
  return std::clamp(value, -largest, largest);
}

/// @return whether something was out of range
bool FAPFrameParser::readHighLevel(bool singleValues, FAPFrame& frame) {
  Viseme& v = frame.viseme;
  Expression& e = frame.expression;
  if (mask_[0]) v.select1 = take();
  if (mask_[0] && singleValues) v.blend = v.select1 == 0.0 ? 0.0 : FAPFrame::fullWeight;
  if (mask_[0] && !singleValues)
    for (double* value : {&v.select2, &v.blend, &v.definition}) *value = take();
  if (mask_[1]) e.select1 = take();
  if (mask_[1] && singleValues) e.intensity1 = e.select1 == 0.0 ? 0.0 : FAPFrame::fullWeight;
  if (mask_[1] && !singleValues)
    for (double* value : {&e.intensity1, &e.select2, &e.intensity2, &e.initialFace, &e.definition}) *value = take();
  return limitHighLevel(frame);
}

}  // namespace mien
