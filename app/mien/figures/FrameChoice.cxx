#include "FrameChoice.h"

#include <algorithm>
#include <cmath>

#include "CsvText.h"
#include "DataFile.h"
#include "FAPSequence.h"
#include "Failure.h"
#include "FigureContext.h"
#include "vtkFAPReader.h"

namespace mien {

namespace {

constexpr size_t mostFrames = 8;  // side by side

std::vector<double> evenNumbers(const FAPSequence& sequence, int count, double begin, double end) {
  std::vector<double> numbers;
  const double last = static_cast<double>(sequence.frames.size()) - 1.0;
  for (int i = 0; i < count; ++i) {
    const double share = begin + (end - begin) * i / std::max(count - 1, 1);
    numbers.push_back(sequence.frames[static_cast<size_t>(std::lround(share * last))].number);
  }
  return numbers;
}

void requireNumber(const FAPSequence& sequence, double number, const std::string& file) {
  const auto& frames = sequence.frames;
  const bool known = std::any_of(frames.begin(), frames.end(), [&](const auto& f) { return f.number == number; });
  if (!known)
    throw ValueFailure("--frames " + shortestText(number) + ": " + file + " has frames " +
                       shortestText(frames.front().number) + " .. " + shortestText(frames.back().number));
}

}  // namespace

std::vector<FaceState> animationStates(FigureContext& context, int count, double begin, double end) {
  FaceState state = context.state();
  if (state.fapFile.empty()) state.fapFile = findDataFile("animation/demo.fap");
  const FAPSequence& sequence = context.pipeline(state).frames()->GetSequence();
  if (sequence.frames.empty()) throw FileFailure(state.fapFile + ": there are no frames to draw");
  std::vector<double> numbers = context.settings().frames;
  if (numbers.empty()) numbers = evenNumbers(sequence, count, begin, end);
  if (numbers.size() > mostFrames)
    throw ValueFailure("--frames has " + std::to_string(numbers.size()) + " numbers; at most " +
                       std::to_string(mostFrames) + " are drawn side by side");
  std::vector<FaceState> states;
  for (const double number : numbers) {
    requireNumber(sequence, number, state.fapFile);
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
