#include "FAPCsvWriter.h"

#include <optional>

#include "FAPFields.h"
#include "FAPWriter.h"
#include "MissingFrames.h"
#include "NumberText.h"
#include "TimeCode.h"

namespace mien {

namespace {

bool isWritten(const FAPMask& used, int field) {
  return used[field < visemeFields ? 0 : 1];
}

void appendHeader(const FAPMask& used, bool hasTimes, std::string& text) {
  text += hasTimes ? "frame,time" : "frame";
  const FAPFrame none;
  int field = 0;
  visitHighLevelFields(none, [&](const char* name, double) {
    if (isWritten(used, field++)) text += std::string(",") + name;
  });
  for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count; ++fap)
    if (used[fap - 1]) text += ",FAP" + std::to_string(fap);
  text += '\n';
}

void appendCell(bool isSet, double value, std::string& text) {
  text += ',';
  if (isSet) appendNumber(text, value);
}

void appendRow(const FAPFrame& frame, const FAPMask& mask, const FAPMask& used, std::optional<double> time,
               std::string& text) {
  appendNumber(text, frame.number);
  if (time) appendCell(true, *time, text);
  int field = 0;
  visitHighLevelFields(frame, [&](const char*, double value) {
    const int fap = field++ < visemeFields ? 0 : 1;
    if (used[fap]) appendCell(mask[fap], value, text);
  });
  for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count; ++fap)
    if (used[fap - 1]) appendCell(mask[fap - 1], frame.value(fap), text);
  text += '\n';
}

}  // namespace

std::string writeFAPCsv(const FAPSequence& sequence, std::string& text) {
  const std::string fault = describeUnwritable(sequence);
  if (!fault.empty()) return fault;
  FAPMask used;
  for (const int fap : sequence.fapsUsed()) used.set(fap - 1);
  std::string written = "# mien fap csv 1; fps=";
  appendNumber(written, sequence.framesPerSecond);
  if (!sequence.version.empty()) written += "; version=" + sequence.version;
  if (sequence.startTime > 0.0) written += "; start=" + timeCodeText(sequence.startTime);
  written += "; name=" + writtenFAPName(sequence.name) + "\n";
  const bool hasTimes = !framesAreMissing(sequence);  // else numbers and times would contradict each other
  appendHeader(used, hasTimes, written);
  for (std::size_t index = 0; index < sequence.frames.size(); ++index) {
    const auto time = hasTimes ? std::optional(sequence.timeOfFrame(index)) : std::nullopt;
    appendRow(sequence.frames[index], sequence.mask(index), used, time, written);
  }
  text = std::move(written);
  return {};
}

}  // namespace mien
