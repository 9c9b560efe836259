#include "CaseMeasures.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>

#include "FaceSample.h"
#include "FaceSeams.h"
#include "ModeSpectrum.h"
#include "SchemeSweep.h"
#include "SeamColumns.h"
#include "SurfaceDeparture.h"

namespace mien {

namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
constexpr const char* distance = "distance_rms_mm";  // to a scan, which a study has not

/// One surface; what several measures share is made when the first of them asks.
class Subject {
 public:
  Subject(const FaceCurves& moved, const FaceCurves& neutral, FaceSurfaceOptions options, int rows, int columns,
          const SweepRecord& swept)
      : moved_(moved), neutral_(neutral), options_(std::move(options)), rows_(rows), columns_(columns), swept_(swept) {}

  double swept(std::size_t measure) const { return swept_.values[measure]; }

  const SeamSummary& seams(bool frontal) {
    if (!whole_) addSeams();
    return frontal ? *frontal_ : *whole_;
  }

  const std::vector<ModeMeasures>& modes() {
    if (modes_.empty()) {
      ModeSpectrum spectrum(options_, RowLayout(rows_, false), moved_.curves.pointsPerCurve, closedAngles(columns_));
      spectrum.setCurves(moved_.curves);
      modes_ = spectrum.measures();
    }
    return modes_;
  }

  const SurfaceDeparture& motion() {
    if (!motion_)
      motion_.emplace(FaceSample(moved_, options_, rows_, columns_), FaceSample(neutral_, options_, rows_, columns_));
    return *motion_;
  }

  int modeCount() const { return options_.modes; }

 private:
  static Eigen::VectorXd closedAngles(int columns) {
    Eigen::VectorXd v(columns + 1);
    for (int i = 0; i <= columns; ++i) v[i] = 2.0 * M_PI * i / columns;
    return v;
  }

  void addSeams() {
    FaceSeams seams(options_, moved_.curves.pointsPerCurve);
    seams.setCurves(moved_.curves);
    whole_.emplace();
    frontal_.emplace();
    for (int seam = 0; seam < FaceSeams::seamCount; ++seam) {
      whole_->add(seams.whole(seam));
      frontal_->add(seams.frontal(seam));
    }
  }

  const FaceCurves& moved_;
  const FaceCurves& neutral_;
  FaceSurfaceOptions options_;
  int rows_, columns_;
  const SweepRecord& swept_;
  std::optional<SeamSummary> whole_, frontal_;
  std::vector<ModeMeasures> modes_;
  std::optional<SurfaceDeparture> motion_;
};

struct Measure {
  std::string name;
  std::function<double(Subject&)> value;
};

/// A new measure is one line here, in a sweep's table or among the columns of seams.
std::vector<Measure> allMeasures() {
  std::vector<Measure> all;
  const std::vector<std::string>& swept = sweepMeasureNames();
  for (std::size_t i = 0; i < swept.size(); ++i)
    if (swept[i] != distance) all.push_back({swept[i], [i](Subject& s) { return s.swept(i); }});
  for (const bool frontal : {false, true})
    for (const SeamColumn& column : seamColumns)
      all.push_back({(frontal ? "frontal_seam_" : "seam_") + std::string(column.name),
                     [frontal, &column](Subject& s) { return column.of(s.seams(frontal)); }});
  all.push_back({"remainder_rms_mm", [](Subject& s) { return s.modes()[s.modeCount()].cumulativeError; }});
  all.push_back(
      {"mode1_energy_share", [](Subject& s) { return s.modeCount() > 0 ? s.modes()[1].energyShare : undefined; }});
  all.push_back({"motion_rms_mm", [](Subject& s) { return s.motion().rms; }});
  all.push_back({"motion_max_mm", [](Subject& s) { return s.motion().maximum; }});
  return all;
}

const std::vector<Measure>& measures() {
  static const std::vector<Measure> all = allMeasures();
  return all;
}

const Measure& measureOf(const std::string& name) {
  return *std::find_if(measures().begin(), measures().end(), [&](const Measure& one) { return one.name == name; });
}

/// A name that no sweep has leaves an empty set, which would mean all.
std::set<std::string> sweptMeasures(const Study& study) {
  const std::vector<std::string>& known = sweepMeasureNames();
  std::set<std::string> wanted = {distance};
  for (const std::string& name : study.measures)
    if (std::find(known.begin(), known.end(), name) != known.end()) wanted.insert(name);
  return wanted;
}

}  // namespace

const std::vector<std::string>& caseMeasureNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Measure& measure : measures()) all.push_back(measure.name);
    return all;
  }();
  return names;
}

bool isCaseMeasure(const std::string& name) {
  const std::vector<std::string>& names = caseMeasureNames();
  return std::find(names.begin(), names.end(), name) != names.end();
}

struct CaseMeasures::Internals {
  const FaceCurves& moved;
  const FaceCurves& neutral;
  SmoothingSweepOptions options;
  std::vector<const Measure*> wanted;
  std::unique_ptr<SchemeSweep> sweep;
};

CaseMeasures::CaseMeasures(const Study& study, const StudyCase& first, const FaceCurves& moved,
                           const FaceCurves& neutral)
    : Impl(new Internals{moved, neutral, {}, {}, {}}) {
  SmoothingSweepOptions& options = this->Impl->options;
  options.surface = first.state.surface;
  options.reference = study.referenceSmoothing;
  options.rows = study.rows;
  options.columns = study.columns;
  options.measures = sweptMeasures(study);
  for (const std::string& name : study.measures) this->Impl->wanted.push_back(&measureOf(name));
  this->Impl->sweep = std::make_unique<SchemeSweep>(moved, options, first.state.surface.scheme);
}

CaseMeasures::~CaseMeasures() = default;

CaseValues CaseMeasures::measure(double smoothing) const {
  const Internals& own = *this->Impl;
  const SweepRecord record = own.sweep->measure(smoothing);
  CaseValues result = {std::vector<double>(own.wanted.size(), undefined), record.reason};
  if (!record.reason.empty()) return result;
  Subject subject(own.moved, own.neutral, sweptSurface(own.options, record.scheme, smoothing), own.options.rows,
                  own.options.columns, record);
  for (std::size_t i = 0; i < own.wanted.size(); ++i) result.values[i] = own.wanted[i]->value(subject);
  return result;
}

}  // namespace mien
