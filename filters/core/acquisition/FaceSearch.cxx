#include "FaceSearch.h"

#include <algorithm>

#include "NumberText.h"

namespace mien {

namespace {

// Bounds of what is taken for a face: doc/decisions.md.
constexpr double leastRelief = 0.6, largestDistance = 3.5;
constexpr double smallestScan = 180.0,
                 largestScan = 2500.0;  // mm, diagonal of the box around a face alone, and a whole person
constexpr double clearlyBetter = 1.5;
constexpr int mostSearched = 4;            // parts
constexpr double smallestSearched = 0.02;  // of the largest part's area: a head on a floor of 2.5 m

double boxDiagonal(const TriangleMesh& mesh) {
  return (mesh.vertices.colwise().maxCoeff() - mesh.vertices.colwise().minCoeff()).norm();
}

std::vector<LengthUnit> unitsOfSize(double size) {
  return unitsThatFit(size, smallestScan, largestScan);
}

std::string describeSize(double size) {
  return "the scan measures " + roundedText(size) + " from corner to corner, which no head does in mm, cm, m or inches";
}

/// One way to lay the reference over the scan.
struct Trial {
  LengthUnit unit;
  HeadFit fit;

  bool isFace() const { return fit.relief >= leastRelief && fit.distance <= largestDistance; }
  double score() const { return fit.distance * (2.0 - fit.relief); }
};

/// Fits in all units that the size allows.
class FaceSearch {
 public:
  FaceSearch(const FaceTemplate& reference, const TriangleMesh& skin, double millimetres)
      : reference_(reference), skin_(skin), millimetres_(millimetres) {}

  std::string find(Trial& best, const Progress& progress) {
    const double size = boxDiagonal(skin_);
    std::vector<LengthUnit> units = unitsOfSize(size);
    if (millimetres_ > 0.0) units = {{"", "", millimetres_}};
    if (units.empty()) return describeSize(size) + askForUnit(0.0);
    for (size_t i = 0; i < units.size(); ++i) {
      const double n = static_cast<double>(units.size());
      Trial trial{units[i], {}};
      if (!fit(trial, partOf(progress, static_cast<double>(i) / n, static_cast<double>(i + 1) / n)))
        return searchStopped;
      trials_.push_back(trial);
    }
    std::sort(trials_.begin(), trials_.end(), [](const Trial& a, const Trial& b) {
      return a.isFace() != b.isFace() ? a.isFace() : a.score() < b.score();
    });
    best = trials_.front();
    return judge();
  }

 private:
  bool fit(Trial& trial, const Progress& progress) const {
    TriangleMesh scaled = skin_;
    scaled.vertices *= trial.unit.millimetres;
    return fitHead(reference_, scaled, trial.fit, progress).empty();
  }

  std::string judge() const {
    const Trial& best = trials_.front();
    if (!best.isFace())
      return "no face was found on the scan: the generic face lies " + roundedText(best.fit.distance) +
             " mm (RMS) from it at best, and their relief agrees by " + roundedText(best.fit.relief) + " (at most " +
             roundedText(largestDistance) + " mm and at least " + roundedText(leastRelief) +
             " are needed); give the landmarks with --landmarks" +
             (millimetres_ > 0.0
                  ? ", or look at the unit: 1 was taken as " + roundedText(millimetres_) + " mm, as asked for"
                  : std::string(", or the unit with --units"));
    if (trials_.size() > 1 && trials_[1].isFace() && trials_[1].score() < clearlyBetter * best.score())
      return "the scan may be in " + best.unit.fullName + " or in " + trials_[1].unit.fullName + askForUnit(0.0);
    return {};
  }

  const FaceTemplate& reference_;
  const TriangleMesh& skin_;
  const double millimetres_;
  std::vector<Trial> trials_;
};

}  // namespace

const char* const searchStopped = "stopped before the curves were measured";

std::string askForUnit(double millimetres) {
  return "; say what its lengths are in with --units mm|cm|m|inch, or how many mm one unit is with --scale" +
         (millimetres > 0.0 ? " (--scale " + roundedText(millimetres) + " would make the head usual in size)" : "");
}

TriangleMesh partAlone(const TriangleMesh& mesh, const MeshParts& parts, int part) {
  std::vector<bool> wanted(static_cast<std::size_t>(parts.count()), false);
  wanted[part] = true;
  return withParts(mesh, parts, wanted);
}

std::vector<int> largeParts(const MeshParts& parts) {
  std::vector<int> large;
  for (int part = 0; part < std::min(parts.count(), mostSearched); ++part)
    if (parts.area[part] >= smallestSearched * parts.area[0]) large.push_back(part);
  return large;
}

std::string findFace(const TriangleMesh& scan, const MeshParts& parts, const FaceTemplate& reference,
                     double millimetres, FoundFace& found, const Progress& progress) {
  const std::vector<int> searched = largeParts(parts);
  const double n = static_cast<double>(searched.size());
  std::string fault;
  for (const int part : searched) {
    Trial best;
    const TriangleMesh skin = partAlone(scan, parts, part);
    const std::string why =
        FaceSearch(reference, skin, millimetres).find(best, partOf(progress, part / n, (part + 1) / n));
    if (why.empty()) found = {part, best.unit, best.fit};
    if (why.empty() || why == searchStopped || best.isFace()) return why;
    if (fault.empty()) fault = why;
  }
  if (parts.count() == 1) return fault;
  return fault + " (of its " + std::to_string(parts.count()) + " parts " +
         (searched.size() == 1 ? "only the largest was" : "the " + std::to_string(searched.size()) + " largest were") +
         " searched; cut away what is no head)";
}

namespace {

/// The units in which one of the parts that findFace searches may be a head.
std::vector<LengthUnit> unitsOfParts(const TriangleMesh& scan, const MeshParts& parts) {
  std::vector<LengthUnit> fitting;
  for (const int part : largeParts(parts))
    for (const LengthUnit& unit : unitsOfSize(boxDiagonal(partAlone(scan, parts, part)))) {
      const auto isIt = [&](const LengthUnit& other) { return other.name == unit.name; };
      if (std::none_of(fitting.begin(), fitting.end(), isIt)) fitting.push_back(unit);
    }
  return fitting;
}

}  // namespace

std::string recogniseScanUnit(const CleanMesh& scan, const FaceTemplate& reference, std::vector<LengthUnit>& fitting,
                              const Progress& progress) {
  const MeshParts parts = partsOf(scan.mesh);
  fitting = unitsOfParts(scan.mesh, parts);
  if (fitting.empty()) return describeSize(boxDiagonal(partAlone(scan.mesh, parts, 0)));
  if (fitting.size() == 1) return {};
  FoundFace best;
  const std::string fault = findFace(scan.mesh, parts, reference, 0.0, best, progress);
  if (fault.empty()) fitting = {best.unit};
  return fault;
}

}  // namespace mien
