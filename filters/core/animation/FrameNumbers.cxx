#include "FrameNumbers.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mien {

namespace {

constexpr double followed = 0.1;       // share of its distance that the phase moves to a time
constexpr double costOfMissing = 0.3;  // against jitter in steps
constexpr int rounds = 4;              // of following and fitting a line

std::vector<double> stepsOf(const std::vector<double>& times) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < times.size(); ++i) steps.push_back(times[i] - times[i - 1]);
  return steps;
}

/// Numbers the times from those before; the first lies at `place` of a grid.
std::vector<double> follow(const std::vector<double>& times, double step, double place) {
  std::vector<double> numbers = {0.0};
  for (std::size_t i = 1; i < times.size(); ++i) {
    double count = std::round((times[i] - place) / step);
    // Two times at one frame: the one before came late and was counted too far.
    if (count < 1.0 && i > 1 && numbers[i - 1] - numbers[i - 2] > 1.0) {
      numbers[i - 1] -= 1.0;
      place -= step;
      count += 1.0;
    }
    count = std::max(1.0, count);
    numbers.push_back(numbers.back() + count);
    place += count * step;
    place += followed * (times[i] - place);
  }
  return numbers;
}

/// The line through numbers and times, and how far they are from it.
FrameNumbers fitted(const std::vector<double>& times, std::vector<double> numbers) {
  const double count = static_cast<double>(times.size());
  const double meanTime = std::accumulate(times.begin(), times.end(), 0.0) / count;
  const double meanNumber = std::accumulate(numbers.begin(), numbers.end(), 0.0) / count;
  double products = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    products += (numbers[i] - meanNumber) * (times[i] - meanTime);
    squares += (numbers[i] - meanNumber) * (numbers[i] - meanNumber);
  }
  FrameNumbers fit{std::move(numbers), 0.0, products / squares, 0.0, 0.0};
  fit.start = meanTime - meanNumber * fit.step;
  double sum = 0.0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double distance = std::abs(times[i] - fit.start - fit.numbers[i] * fit.step) / fit.step;
    sum += distance * distance;
    fit.largestJitter = std::max(fit.largestJitter, distance);
  }
  fit.jitter = std::sqrt(sum / count);
  return fit;
}

double costOf(const FrameNumbers& fit) {
  return fit.jitter + costOfMissing * fit.missing() / (fit.numbers.back() + 1.0);
}

std::vector<double> stepsToTry(const std::vector<double>& times, double clockRate) {
  std::vector<double> tried;
  for (const double frames : {0.25, 0.5, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0})
    if (clockRate > 0.0) tried.push_back(frames / clockRate);
  std::vector<double> steps = stepsOf(times);
  const std::size_t middle = (steps.size() - 1) / 2;  // of two the shorter: the other is a gap
  std::nth_element(steps.begin(), steps.begin() + middle, steps.end());
  const double usual = steps[middle];
  double sum = 0.0, count = 0.0;
  for (const double step : steps)
    if (step < 2.5 * usual) sum += step, count += 1.0;
  tried.push_back(usual);
  tried.push_back(sum / count);
  tried.push_back((times.back() - times.front()) / static_cast<double>(steps.size()));
  return tried;
}

FrameNumbers settled(const std::vector<double>& times, double step) {
  FrameNumbers best = fitted(times, follow(times, step, times.front()));
  FrameNumbers next = best;
  for (int round = 1; round < rounds && next.step > 0.0; ++round) {
    next = fitted(times, follow(times, next.step, next.start));
    if (costOf(next) < costOf(best)) best = next;
  }
  return best;
}

/// The frames that a time code itself names; nothing where two times are in one.
std::vector<double> namedFrames(const std::vector<double>& times, double clockRate) {
  constexpr double rounding = 1e-4;  // frames
  std::vector<double> numbers;
  for (const double time : times) {
    numbers.push_back(std::floor(time * clockRate + rounding));
    if (numbers.size() > 1 && numbers.back() <= numbers[numbers.size() - 2]) return {};
  }
  const double first = numbers.front();
  for (double& number : numbers) number -= first;
  return numbers;
}

}  // namespace

FrameNumbers FrameNumbers::of(const std::vector<double>& times, double clockRate) {
  FrameNumbers best;
  for (const double step : stepsToTry(times, clockRate)) {
    FrameNumbers fit = settled(times, step);
    if (best.numbers.empty() || costOf(fit) < costOf(best) - 1e-9) best = std::move(fit);
  }
  if (clockRate <= 0.0) return best;
  std::vector<double> named = namedFrames(times, clockRate);
  if (named.empty()) return best;
  FrameNumbers fit = fitted(times, std::move(named));
  return fit.missing() < best.missing() ? fit : best;
}

}  // namespace mien
