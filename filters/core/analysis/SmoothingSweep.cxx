#include "SmoothingSweep.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>

#include "HelperThreads.h"
#include "SchemeSweep.h"

namespace mien {

namespace {

constexpr int minimumColumns = 3;
constexpr int largestSide = 4096;
constexpr std::chrono::milliseconds longestWait(20);  // a word that was missed costs no more

/// The records of a sweep, worked off by several threads.
class Work {
 public:
  Work(const FaceCurves& face, const SmoothingSweepOptions& sweep)
      : sweep_(sweep), records_(sweep.schemes.size() * sweep.smoothing.size()) {
    for (const std::string& scheme : sweep.schemes)
      schemes_.push_back(std::make_unique<SchemeSweep>(face, sweep, scheme));
  }

  /// Takes records until none is left; `goOn` is asked after each.
  template <class Function>
  void run(const Function& goOn) {
    for (size_t i = next_++; i < records_.size() && !cancelled_; i = next_++) {
      const size_t count = sweep_.smoothing.size();
      records_[i] = schemes_[i / count]->measure(sweep_.smoothing[i % count]);
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

  const SmoothingSweepOptions& sweep_;
  std::vector<std::unique_ptr<SchemeSweep>> schemes_;
  std::vector<SweepRecord> records_;
  std::atomic<size_t> next_{0}, done_{0};
  std::atomic<bool> cancelled_{false};
  std::mutex lock_;
  std::condition_variable finished_;
  std::exception_ptr failure_;
};

}  // namespace

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
    if (!findFaceScheme(scheme)) return describeFault(sweptSurface(sweep, scheme, 1.0), pointsPerCurve);
  for (double a : sweep.smoothing)
    if (!(a > 0.0 && a <= FaceSurfaceOptions::largestSmoothing))
      return describeFault(sweptSurface(sweep, sweep.schemes[0], a), pointsPerCurve);
  if (sweep.rows < RowLayout::minimumRows || sweep.rows > largestSide || sweep.columns < minimumColumns ||
      sweep.columns > largestSide)
    return "a resolution of " + std::to_string(sweep.rows) + "x" + std::to_string(sweep.columns) + " is outside " +
           std::to_string(RowLayout::minimumRows) + "x" + std::to_string(minimumColumns) + " .. " +
           std::to_string(largestSide) + "x" + std::to_string(largestSide);
  FaceSurfaceOptions options = sweptSurface(sweep, "spline", sweep.reference);
  return describeFault(options, pointsPerCurve);
}

std::optional<std::vector<SweepRecord>> smoothingSweep(const FaceCurves& face, const SmoothingSweepOptions& options,
                                                       const std::function<bool(double)>& progress) {
  Work work(face, options);
  HelperThreads helpers;
  for (size_t i = 1; i < std::min<size_t>(std::max(options.threads, 1), work.size()); ++i)
    helpers.start([&] { work.runUnseen(); });
  work.runSeen([&](double share) { return !progress || progress(share); });
  helpers.join();
  work.rethrow();
  if (work.cancelled()) return std::nullopt;
  return work.take();
}

}  // namespace mien
