#include "SchemeSweep.h"

#include <algorithm>
#include <limits>
#include <optional>

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

/// One surface of the sweep; what several measures share is made when the first of them asks.
struct Subject {
  const FaceCurves& face;
  const SmoothingSweepOptions& sweep;
  const FaceSurfaceOptions& options;
  const FaceSample& sample;
  const FaceSample& reference;  ///< of the same scheme at the reference a
  const FaceSample& upright;    ///< of the same scheme, where a does not show
  mutable std::optional<SurfaceDeparture> madeDeparture;
  mutable std::optional<FoldedCells> madeFolds;

  const SurfaceDeparture& departure() const {
    if (!madeDeparture) madeDeparture.emplace(sample, reference);
    return *madeDeparture;
  }
  const FoldedCells& folds() const {
    if (!madeFolds) madeFolds.emplace(sample);
    return *madeFolds;
  }
};

struct Measure {
  const char* name;
  double (*value)(const Subject&);
  bool compares = false;  ///< with the surface at another a
};

double lebesgueOf(const Subject& s) {
  return faceLebesgueConstant(s.options,
                              HarmonicSplit(s.face.curves.pointsPerCurve, s.options.modes, s.options.remainder));
}

/// A new measure is one line here.
const Measure measures[] = {
    {"area_mm2", [](const Subject& s) { return faceArea(s.sample); }},
    {"rms_departure_mm", [](const Subject& s) { return s.departure().rms; }, true},
    {"max_departure_mm", [](const Subject& s) { return s.departure().maximum; }, true},
    {"curve_miss_rms_mm", [](const Subject& s) { return curveMiss(s.face, s.options); }},
    {"lebesgue", lebesgueOf},
    {"g1_max_deg", [](const Subject& s) { return largestSeamAngle(s.sample); }},
    {"folded_cells", [](const Subject& s) { return static_cast<double>(s.folds().count()); }},
    {"folded_cells_on_seams", [](const Subject& s) { return static_cast<double>(s.folds().countOnSeams()); }},
    {"turned_area_share", [](const Subject& s) { return turnedAreaShare(s.sample, s.upright); }, true},
    {"willmore_energy", [](const Subject& s) { return willmoreEnergy(s.sample); }},
    {"box_ratio", [](const Subject& s) { return boxRatio(s.sample, s.face.curves); }},
    {"distance_rms_mm", [](const Subject& s) { return s.sweep.distance ? s.sweep.distance(s.sample) : undefined; }},
};

bool isWanted(const SmoothingSweepOptions& sweep, const Measure& measure) {
  return sweep.measures.empty() || sweep.measures.count(measure.name) > 0;
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

}  // namespace

/// What the surfaces of one scheme are compared with.
struct SchemeSweep::Origins {
  Attempt reference, upright;

  Origins(const FaceCurves& face, const SmoothingSweepOptions& sweep, const std::string& scheme)
      : reference(face, sweptSurface(sweep, scheme, sweep.reference), sweep),
        upright(face, sweptSurface(sweep, scheme, SmoothingSweepOptions::uprightSmoothing), sweep) {}
};

FaceSurfaceOptions sweptSurface(const SmoothingSweepOptions& sweep, const std::string& scheme, double smoothing) {
  FaceSurfaceOptions options = sweep.surface;
  options.scheme = scheme;
  options.smoothing.fill(smoothing);
  return options;
}

SchemeSweep::SchemeSweep(const FaceCurves& face, const SmoothingSweepOptions& sweep, const std::string& scheme)
    : face_(face), sweep_(sweep), scheme_(scheme) {
  const auto needsOrigins = [&](const Measure& measure) { return measure.compares && isWanted(sweep, measure); };
  if (std::any_of(std::begin(measures), std::end(measures), needsOrigins))
    origins_ = std::make_unique<Origins>(face, sweep, scheme);
}

SchemeSweep::~SchemeSweep() = default;

SweepRecord SchemeSweep::measure(double smoothing) const {
  SweepRecord record = {scheme_, smoothing, std::vector<double>(std::size(measures), undefined), {}};
  const FaceSurfaceOptions options = sweptSurface(sweep_, scheme_, smoothing);
  const Attempt attempt(face_, options, sweep_);
  record.reason = attempt.reason;
  if (!attempt.reason.empty()) return record;
  const auto sampleOr = [&](const Attempt Origins::*other) -> const FaceSample& {
    return origins_ && (*origins_.*other).reason.empty() ? *(*origins_.*other).sample : *attempt.sample;
  };
  const Subject subject = {
      face_,        sweep_,      options, *attempt.sample, sampleOr(&Origins::reference), sampleOr(&Origins::upright),
      std::nullopt, std::nullopt};
  for (size_t i = 0; i < std::size(measures); ++i)
    if (isWanted(sweep_, measures[i])) record.values[i] = measures[i].value(subject);
  return record;
}

const std::vector<std::string>& sweepMeasureNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Measure& measure : measures) all.push_back(measure.name);
    return all;
  }();
  return names;
}

}  // namespace mien
