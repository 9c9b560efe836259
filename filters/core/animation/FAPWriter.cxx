#include "FAPWriter.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "FAPFields.h"
#include "FAPParser.h"
#include "NumberText.h"

namespace mien {

namespace {

constexpr std::size_t longestWrittenName = 1024;  // bytes; keeps the header far below the longest line read
constexpr std::size_t bytesPerMaskLine = 2 * FAPFrame::count;

void appendMask(const FAPMask& mask, std::string& text) {
  for (int i = 0; i < FAPFrame::count; ++i) {
    text += mask[i] ? '1' : '0';
    text += i + 1 < FAPFrame::count ? ' ' : '\n';
  }
}

void listValues(const FAPFrame& frame, const FAPMask& mask, std::vector<double>& values) {
  const Viseme& v = frame.viseme;
  const Expression& e = frame.expression;
  values.assign(1, frame.number);
  if (mask[0]) values.insert(values.end(), {v.select1, v.select2, v.blend, v.definition});
  if (mask[1])
    values.insert(values.end(), {e.select1, e.intensity1, e.select2, e.intensity2, e.initialFace, e.definition});
  for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count; ++fap)
    if (mask[fap - 1]) values.push_back(frame.value(fap));
}

void appendValues(const std::vector<double>& values, std::string& text) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    appendNumber(text, values[i]);
    text += i + 1 < values.size() ? ' ' : '\n';
  }
}

std::string header(const FAPSequence& sequence) {
  std::string line = (sequence.version.empty() ? "2.1" : sequence.version) + ' ' + writtenFAPName(sequence.name) + ' ';
  appendNumber(line, sequence.framesPerSecond);
  return line + ' ' + std::to_string(sequence.frames.size()) + '\n';
}

bool isFinite(const FAPFrame& frame) {
  bool finite = std::isfinite(frame.number);
  visitHighLevelFields(frame, [&](const char*, double value) { finite = finite && std::isfinite(value); });
  for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count; ++fap)
    finite = finite && std::isfinite(frame.value(fap));
  return finite;
}

}  // namespace

std::string writtenFAPName(std::string name) {
  const auto isControl = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  std::replace_if(name.begin(), name.end(), isControl, ' ');
  name.erase(0, std::min(name.find_first_not_of(' '), name.size()));
  name.resize(std::min(name.size(), longestWrittenName));
  name.resize(name.find_last_not_of(' ') + 1);
  return name.empty() ? "untitled" : name;
}

std::string describeUnwritable(const FAPSequence& sequence) {
  if (sequence.frames.empty()) return "there are no frames to write; a .fap file holds at least one";
  const double rate = sequence.framesPerSecond;
  if (!(rate >= slowestFAPRate && rate <= fastestFAPRate))
    return "the frame rate cannot be written; it must be from 0.001 to 100000 frames per second";
  for (std::size_t index = 0; index < sequence.frames.size(); ++index)
    if (!isFinite(sequence.frames[index]))
      return "frame " + std::to_string(index) +
             " (counted from 0) has a value that is not finite; a file cannot hold it";
  return {};
}

std::string writeFAP(const FAPSequence& sequence, std::string& text) {
  const std::string fault = describeUnwritable(sequence);
  if (!fault.empty()) return fault;
  std::string written = header(sequence);
  written.reserve(written.size() + sequence.frames.size() * 2 * bytesPerMaskLine);
  std::vector<double> values;
  for (std::size_t index = 0; index < sequence.frames.size(); ++index) {
    const FAPMask mask = sequence.mask(index);
    listValues(sequence.frames[index], mask, values);
    appendMask(mask, written);
    appendValues(values, written);
  }
  text = std::move(written);
  return {};
}

}  // namespace mien
