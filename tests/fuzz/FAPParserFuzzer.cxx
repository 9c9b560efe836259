#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "FAPParser.h"
#include "FAPWriter.h"

using namespace mien;

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

void requireRefusal(const FAPParseError& error, std::string_view text, const FAPSequence& untouched) {
  const auto lines = std::count_if(text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; });
  require(error.line >= 1 && error.line <= lines + 1);
  require(!error.message.empty() && error.message.size() < 200);
  require(untouched.name == "before" && untouched.frames.empty());
}

void requireInRange(const FAPFrame& frame) {
  const Viseme& v = frame.viseme;
  const Expression& e = frame.expression;
  require(std::isfinite(frame.number));
  for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count; ++fap) require(std::isfinite(frame.value(fap)));
  for (double selection : {v.select1, v.select2}) require(selection >= 0 && selection <= 14);
  for (double selection : {e.select1, e.select2}) require(selection >= 0 && selection <= 6);
  for (double weight : {v.blend, e.intensity1, e.intensity2}) require(weight >= 0 && weight <= 63);
  for (double flag : {v.definition, e.initialFace, e.definition}) require(flag == 0 || flag == 1);
}

void requirePlayable(const FAPSequence& sequence) {
  require(!sequence.frames.empty() && sequence.masks.size() == sequence.frames.size());
  for (const FAPFrame& frame : sequence.frames) requireInRange(frame);
  require(std::isfinite(sequence.duration()));
  require(sequence.indexAtTime(sequence.duration()) == sequence.frames.size() - 1);
}

/// What was read can be written, reads again, and is then written the same.
void requireRoundTrip(const FAPSequence& sequence) {
  std::string first, second;
  require(writeFAP(sequence, first).empty());
  FAPSequence again;
  require(!parseFAP(first, again));
  require(again.masks == sequence.masks);
  require(writeFAP(again, second).empty());
  require(first == second);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  FAPSequence sequence;
  sequence.name = "before";
  const auto error = parseFAP(text, sequence);
  if (error) {
    requireRefusal(*error, text, sequence);
    return 0;
  }
  requirePlayable(sequence);
  requireRoundTrip(sequence);
  return 0;
}
