#include "FrameChoice.h"

#include <algorithm>
#include <cmath>

#include "CsvText.h"
#include "DataFile.h"
#include "FAPSequence.h"
#include "Failure.h"
#include "FigureContext.h"
#include "FrameOptions.h"
#include "vtkFAPReader.h"

namespace mien {

namespace {

constexpr size_t mostFrames = 8;  // side by side

/// How far a frame is from rest: FAP units, each selection of FAP 1 or 2 as one large value.
double strength(const FAPFrame& frame) {
  constexpr double selection = 500.0;
  double sum = selection * ((frame.viseme.select1 > 0.0) + (frame.expression.select1 > 0.0));
  for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count; ++fap) sum += std::abs(frame.value(fap));
  return sum;
}

/// The strongest frame of each of `count` equal parts between two shares of the file.
std::vector<double> strongestNumbers(const FAPSequence& sequence, int count, double begin, double end) {
  const std::vector<FAPFrame>& frames = sequence.frames;
  const auto at = [&](int part) {
    const double share = begin + (end - begin) * part / count;
    return std::min(static_cast<size_t>(share * static_cast<double>(frames.size())), frames.size() - 1);
  };
  std::vector<double> numbers;
  for (int part = 0; part < count; ++part) {
    const auto first = frames.begin() + at(part), last = frames.begin() + std::max(at(part + 1), at(part) + 1);
    const auto weaker = [](const FAPFrame& a, const FAPFrame& b) { return strength(a) < strength(b); };
    numbers.push_back(std::max_element(first, last, weaker)->number);
  }
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());  // a file of few frames
  return numbers;
}

std::vector<double> numbersOf(const std::string& text, const FAPSequence& sequence) {
  std::vector<double> numbers;
  for (const size_t index : frameIndices("--frames", text, sequence)) numbers.push_back(sequence.frames[index].number);
  if (numbers.size() > mostFrames)
    throw ValueFailure("--frames has " + std::to_string(numbers.size()) + " frames; at most " +
                       std::to_string(mostFrames) + " are drawn side by side");
  return numbers;
}

}  // namespace

std::vector<FaceState> animationStates(FigureContext& context, int count, double begin, double end) {
  FaceState state = context.state();
  if (state.fapFile.empty()) state.fapFile = findDataFile("animation/demo.fap");
  const FAPSequence& sequence = context.pipeline(state).frames()->GetSequence();
  if (sequence.frames.empty()) throw FileFailure(state.fapFile + ": there are no frames to draw");
  std::vector<double> numbers = strongestNumbers(sequence, count, begin, end);
  if (!context.settings().frames.empty()) numbers = numbersOf(context.settings().frames, sequence);
  std::vector<FaceState> states;
  for (const double number : numbers) {
    states.push_back(state);
    states.back().frameChoice = FaceState::FrameChoice::Number;
    states.back().frame = number;
  }
  return states;
}

std::string frameHeading(const FaceState& state) {
  return "frame " + shortestText(state.frame);
}

}  // namespace mien
