#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "FaceCurves.h"
#include "FaceSample.h"
#include "FaceSurface.h"

namespace mien {

/// What a sweep over the smoothing parameter a measures, and on what.
struct SmoothingSweepOptions {
  /// At this a every scheme is near its limit for a -> 0: what a surface is turned against.
  static constexpr double uprightSmoothing = 0.1;

  FaceSurfaceOptions surface;        ///< all but scheme and smoothing
  std::vector<std::string> schemes;  ///< names as in faceSchemes()
  std::vector<double> smoothing;     ///< the values of a, the same for all patches
  double reference = 1.0;            ///< the a from whose surface (same scheme) departures are taken
  int rows = 112, columns = 80;      ///< grid, as vtkPDEFaceFilter counts it
  int threads = 1;
  std::set<std::string> measures;  ///< names of those that are computed, the others are NaN; empty: all

  /// The RMS distance of a sample to something outside of the mathematics, mm; called from several threads. Without it:
  /// NaN.
  std::function<double(const FaceSample&)> distance;
};

/// One scheme at one a.
struct SweepRecord {
  std::string scheme;
  double smoothing = 0.0;
  std::vector<double> values;  ///< in the order of sweepMeasureNames(); all NaN where there is no surface
  std::string reason;          ///< one sentence that says why there is no surface, or nothing
};

/// The names of all measures, in the order of their columns.
const std::vector<std::string>& sweepMeasureNames();

/// Position of a measure's name, or -1.
int sweepMeasure(const std::string& name);

/// A measure of a record by its name, which must be one of them.
double sweepValue(const SweepRecord& record, const std::string& measure);

/// One sentence that says which option is out of range, or nothing. A value of a that a scheme refuses is no fault but
/// a record with its reason.
std::string describeFault(const SmoothingSweepOptions& options, int pointsPerCurve);

/// All schemes at all a, scheme after scheme, a in the order given; the number of threads does not change a bit of it.
///
/// @param progress  told the share that is done (0 .. 1), on the calling thread only; false cancels
/// @return nothing when cancelled; an exception of any thread reaches the caller once all threads have ended
std::optional<std::vector<SweepRecord>> smoothingSweep(const FaceCurves& face, const SmoothingSweepOptions& options,
                                                       const std::function<bool(double)>& progress = {});

}  // namespace mien
