#include "BreakdownSearch.h"

#include <algorithm>
#include <cmath>

#include "BoxRatio.h"
#include "TurnedArea.h"

namespace mien {

namespace {

constexpr double firstStep = 1.2;  // between values of a around that of the sweep
constexpr double mostSmoothing = FaceSurfaceOptions::largestSmoothing;

FaceSurfaceOptions optionsAt(FaceSurfaceOptions options, double smoothing) {
  options.smoothing.fill(smoothing);
  return options;
}

/// The surfaces of one scheme on one grid.
class Trial {
 public:
  Trial(const FaceCurves& face, const FaceSurfaceOptions& options, int rows, int columns)
      : face_(face),
        options_(options),
        rows_(rows),
        columns_(columns),
        upright_(face, optionsAt(options, SmoothingSweepOptions::uprightSmoothing), rows, columns) {}

  /// Why the surface is no face, or nothing.
  std::string reason(double a) const {
    const FaceSurfaceOptions options = optionsAt(options_, a);
    const std::string fault = describeFault(options, face_.curves.pointsPerCurve);
    if (!fault.empty()) return fault;
    const FaceSample sample(face_, options, rows_, columns_);
    if (!sample.fault().empty()) return sample.fault();
    return SweepBreakdown::reasonOf(boxRatio(sample, face_.curves), turnedAreaShare(sample, upright_));
  }

 private:
  const FaceCurves& face_;
  FaceSurfaceOptions options_;
  int rows_, columns_;
  FaceSample upright_;
};

/// A sound a and a broken one, which close in on each other.
class Bracket {
 public:
  Bracket(const Trial& trial, double least, const std::function<bool()>& goOn)
      : trial_(trial), least_(least), goOn_(goOn) {}

  /// @param guess  of the smallest broken a
  /// @param step   factor between values around it
  void close(double guess, double step) {
    broken_ = guess;
    sound_ = std::max(least_, guess / step);
    while (isSound(broken_) && broken_ < mostSmoothing) {
      sound_ = broken_;
      broken_ = std::min(broken_ * step, mostSmoothing);
    }
    while (sound_ > least_ && !isSound(sound_)) {
      broken_ = sound_;
      sound_ = std::max(least_, sound_ / step);
    }
    while (!ended_ && broken_ > (1.0 + BreakdownSearch::tolerance) * sound_) {
      const double middle = std::sqrt(sound_ * broken_);
      (isSound(middle) ? sound_ : broken_) = middle;
    }
  }

  double broken() const { return broken_; }
  bool ended() const { return ended_; }

 private:
  /// Everything is, once the search has ended.
  bool isSound(double a) {
    ended_ = ended_ || (goOn_ && !goOn_());
    return ended_ || trial_.reason(a).empty();
  }

  const Trial& trial_;
  double least_, sound_ = 0.0, broken_ = 0.0;
  const std::function<bool()>& goOn_;
  bool ended_ = false;
};

}  // namespace

BreakdownSearch::BreakdownSearch(const FaceCurves& face, const FaceSurfaceOptions& surface, double least)
    : face_(face), surface_(surface), least_(least) {}

SweepBreakdown BreakdownSearch::refine(const SweepBreakdown& coarse) const {
  SweepBreakdown breakdown = coarse;
  FaceSurfaceOptions options = surface_;
  options.scheme = coarse.scheme;
  double step = firstStep;
  for (int grid = rows; coarse.found && grid <= mostRows; grid *= 2) {
    const Trial trial(face_, options, grid, grid / rows * columns);
    Bracket bracket(trial, least_, goOn_);
    bracket.close(breakdown.smoothing, step);
    if (bracket.ended()) break;
    const double change = std::abs(bracket.broken() / breakdown.smoothing - 1.0);
    breakdown.smoothing = bracket.broken();
    breakdown.reason = trial.reason(bracket.broken());
    if (grid > rows && change <= tolerance) break;
    step = 1.0 + tolerance;
  }
  return breakdown;
}

}  // namespace mien
