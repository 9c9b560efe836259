#include "SmoothingSweep.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <limits>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>

#include "BoxRatio.h"
#include "CurveMiss.h"
#include "FaceArea.h"
#include "FaceLebesgue.h"
#include "FoldedCells.h"
#include "LargestSeamAngle.h"
#include "SurfaceDeparture.h"
#include "TurnedArea.h"
#include "WillmoreEnergy.h"

namespace mien {

namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
constexpr int minimumColumns = 3;
constexpr int largestSide = 4096;
constexpr std::chrono::milliseconds longestWait(20);  // a word that was missed costs no more

/// One surface of the sweep with what several measures share.
struct Subject {
  const FaceCurves& face;
  const SmoothingSweepOptions& sweep;
  const FaceSurfaceOptions& options;
  const FaceSample& sample;
  const FaceSample& upright;  ///< of the same scheme, where a does not show
  SurfaceDeparture departure;
  FoldedCells folds;
};

struct Measure {
  const char* name;
  double (*value)(const Subject&);
};

double lebesgueOf(const Subject& s) {
  return faceLebesgueConstant(s.options,
                              HarmonicSplit(s.face.curves.pointsPerCurve, s.options.modes, s.options.remainder));
}

/// A new measure is one line here.
const Measure measures[] = {
    {"area_mm2", [](const Subject& s) { return faceArea(s.sample); }},
    {"rms_departure_mm", [](const Subject& s) { return s.departure.rms; }},
    {"max_departure_mm", [](const Subject& s) { return s.departure.maximum; }},
    {"curve_miss_rms_mm", [](const Subject& s) { return curveMiss(s.face, s.options); }},
    {"lebesgue", lebesgueOf},
    {"g1_max_deg", [](const Subject& s) { return largestSeamAngle(s.sample); }},
    {"folded_cells", [](const Subject& s) { return static_cast<double>(s.folds.count()); }},
    {"folded_cells_on_seams", [](const Subject& s) { return static_cast<double>(s.folds.countOnSeams()); }},
    {"turned_area_share", [](const Subject& s) { return turnedAreaShare(s.sample, s.upright); }},
    {"willmore_energy", [](const Subject& s) { return willmoreEnergy(s.sample); }},
    {"box_ratio", [](const Subject& s) { return boxRatio(s.sample, s.face.curves); }},
    {"distance_rms_mm", [](const Subject& s) { return s.sweep.distance ? s.sweep.distance(s.sample) : undefined; }},
};

FaceSurfaceOptions optionsOf(const SmoothingSweepOptions& sweep, const std::string& scheme, double smoothing) {
  FaceSurfaceOptions options = sweep.surface;
  options.scheme = scheme;
  options.smoothing.fill(smoothing);
  return options;
}

/// A surface, or the reason why there is none.
struct Attempt {
  std::unique_ptr<FaceSample> sample;
  std::string reason;

  Attempt(const FaceCurves& face, const FaceSurfaceOptions& options, const SmoothingSweepOptions& sweep)
      : reason(describeFault(options, face.curves.pointsPerCurve)) {
    if (!reason.empty()) return;
    sample = std::make_unique<FaceSample>(face, options, sweep.rows, sweep.columns);
    reason = sample->fault();
  }
};

/// What the surfaces of one scheme are compared with.
struct Origins {
  Attempt reference, upright;

  Origins(const FaceCurves& face, const SmoothingSweepOptions& sweep, const std::string& scheme)
      : reference(face, optionsOf(sweep, scheme, sweep.reference), sweep),
        upright(face, optionsOf(sweep, scheme, SmoothingSweepOptions::uprightSmoothing), sweep) {}
};

SweepRecord measure(const FaceCurves& face, const SmoothingSweepOptions& sweep, const Origins& origins,
                    const std::string& scheme, double smoothing) {
  SweepRecord record = {scheme, smoothing, std::vector<double>(std::size(measures), undefined), {}};
  const FaceSurfaceOptions options = optionsOf(sweep, scheme, smoothing);
  const Attempt attempt(face, options, sweep);
  record.reason = attempt.reason;
  if (!attempt.reason.empty()) return record;
  const auto sampleOr = [&](const Attempt& other) -> const FaceSample& {
    return other.reason.empty() ? *other.sample : *attempt.sample;
  };
  const FaceSample& sample = *attempt.sample;
  const Subject subject = {face,
                           sweep,
                           options,
                           sample,
                           sampleOr(origins.upright),
                           {sample, sampleOr(origins.reference)},
                           FoldedCells(sample)};
  for (size_t i = 0; i < std::size(measures); ++i) record.values[i] = measures[i].value(subject);
  return record;
}

/// The records of a sweep, worked off by several threads.
class Work {
 public:
  Work(const FaceCurves& face, const SmoothingSweepOptions& sweep)
      : face_(face), sweep_(sweep), records_(sweep.schemes.size() * sweep.smoothing.size()) {
    for (const std::string& scheme : sweep.schemes) origins_.push_back(std::make_unique<Origins>(face, sweep, scheme));
  }

  /// Takes records until none is left; `goOn` is asked after each.
  template <class Function>
  void run(const Function& goOn) {
    for (size_t i = next_++; i < records_.size() && !cancelled_; i = next_++) {
      const size_t scheme = i / sweep_.smoothing.size();
      records_[i] = measure(face_, sweep_, *origins_[scheme], sweep_.schemes[scheme],
                            sweep_.smoothing[i % sweep_.smoothing.size()]);
      ++done_;
      finished_.notify_one();
      if (!goOn(static_cast<double>(done_) / records_.size())) cancelled_ = true;
    }
  }

  /// Keeps the first exception of any thread for rethrow() and ends the work of all.
  template <class Function>
  void runSafely(const Function& work) {
    try {
      work();
    } catch (...) {
      const std::lock_guard<std::mutex> guard(lock_);
      if (!failure_) failure_ = std::current_exception();
      cancelled_ = true;
    }
  }
  void runUnseen() {
    runSafely([this] { run([](double) { return true; }); });
  }
  /// Is heard to the end: `goOn` is asked about what the other threads still work on, too.
  template <class Function>
  void runSeen(const Function& goOn) {
    runSafely([&] {
      double told = 0.0;
      const auto tell = [&](double share) { return goOn(told = share); };
      run(tell);
      await(tell, told);
    });
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

  size_t size() const { return records_.size(); }
  bool cancelled() const { return cancelled_; }
  std::vector<SweepRecord> take() { return std::move(records_); }

 private:
  /// Until all records are there or the work was ended.
  template <class Function>
  void await(const Function& goOn, const double& told) {
    for (double share = told; !cancelled_ && told < 1.0; share = static_cast<double>(done_) / records_.size()) {
      if (share > told) {
        if (!goOn(share)) cancelled_ = true;
        continue;
      }
      std::unique_lock<std::mutex> guard(lock_);
      finished_.wait_for(guard, longestWait);
    }
  }

  const FaceCurves& face_;
  const SmoothingSweepOptions& sweep_;
  std::vector<std::unique_ptr<Origins>> origins_;
  std::vector<SweepRecord> records_;
  std::atomic<size_t> next_{0}, done_{0};
  std::atomic<bool> cancelled_{false};
  std::mutex lock_;
  std::condition_variable finished_;
  std::exception_ptr failure_;
};

/// Threads that are joined whatever happens; where the system gives no more, fewer do the work.
class Helpers {
 public:
  ~Helpers() { join(); }

  template <class Function>
  void start(const Function& function) {
    try {
      threads_.emplace_back(function);
    } catch (const std::system_error&) {
    }
  }
  void join() {
    for (std::thread& thread : threads_) thread.join();
    threads_.clear();
  }

 private:
  std::vector<std::thread> threads_;
};

}  // namespace

const std::vector<std::string>& sweepMeasureNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Measure& measure : measures) all.push_back(measure.name);
    return all;
  }();
  return names;
}

int sweepMeasure(const std::string& name) {
  const auto& names = sweepMeasureNames();
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

double sweepValue(const SweepRecord& record, const std::string& measure) {
  return record.values[sweepMeasure(measure)];
}

std::string describeFault(const SmoothingSweepOptions& sweep, int pointsPerCurve) {
  if (sweep.schemes.empty()) return "the sweep has no scheme; name at least one";
  if (sweep.smoothing.empty()) return "the sweep has no values of a; give at least one";
  for (const std::string& scheme : sweep.schemes)
    if (!findFaceScheme(scheme)) return describeFault(optionsOf(sweep, scheme, 1.0), pointsPerCurve);
  for (double a : sweep.smoothing)
    if (!(a > 0.0 && a <= FaceSurfaceOptions::largestSmoothing))
      return describeFault(optionsOf(sweep, sweep.schemes[0], a), pointsPerCurve);
  if (sweep.rows < RowLayout::minimumRows || sweep.rows > largestSide || sweep.columns < minimumColumns ||
      sweep.columns > largestSide)
    return "a resolution of " + std::to_string(sweep.rows) + "x" + std::to_string(sweep.columns) + " is outside " +
           std::to_string(RowLayout::minimumRows) + "x" + std::to_string(minimumColumns) + " .. " +
           std::to_string(largestSide) + "x" + std::to_string(largestSide);
  FaceSurfaceOptions options = optionsOf(sweep, "spline", sweep.reference);
  return describeFault(options, pointsPerCurve);
}

std::optional<std::vector<SweepRecord>> smoothingSweep(const FaceCurves& face, const SmoothingSweepOptions& options,
                                                       const std::function<bool(double)>& progress) {
  Work work(face, options);
  Helpers helpers;
  for (size_t i = 1; i < std::min<size_t>(std::max(options.threads, 1), work.size()); ++i)
    helpers.start([&] { work.runUnseen(); });
  work.runSeen([&](double share) { return !progress || progress(share); });
  helpers.join();
  work.rethrow();
  if (work.cancelled()) return std::nullopt;
  return work.take();
}

}  // namespace mien
