#include "ScanAcquisition.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "FaceAcquisition.h"
#include "FaceRegistration.h"
#include "HeadFit.h"
#include "NumberText.h"
#include "RadialSkin.h"
#include "TriangleDistance.h"

namespace mien {

namespace {

// Bounds of what is taken for a face: doc/decisions.md.
constexpr double leastRelief = 0.6, largestDistance = 3.5;
constexpr double smallestScan = 180.0,
                 largestScan = 2500.0;  // mm, diagonal of the box around a face alone, and a whole person
constexpr double clearlyBetter = 1.5;
constexpr double uprightWithin = 10.0 * M_PI / 180.0, nearWithin = 60.0;  // mm
constexpr double usualEyes = 90.0;                                        // mm
constexpr double deepestLandmarks = 2.0;                                  // mm, median
constexpr double largestLandmarkMisfit = 20.0;                            // mm RMS
const char* const stopped = "stopped before the curves were measured";

std::string askForUnit(double millimetres) {
  return "; say what its lengths are in with --units mm|cm|m|inch, or how many mm one unit is with --scale" +
         (millimetres > 0.0 ? " (--scale " + roundedText(millimetres) + " would make the head usual in size)" : "");
}

bool any(const LandmarkTable::Given& given) {
  return std::find(given.begin(), given.end(), true) != given.end();
}

void useUnit(const LengthUnit& unit, ScanReport& report) {
  report.unit = unit.name;
  report.millimetres = unit.millimetres;
  report.unitRecognised = true;
}

std::string recogniseUnit(double eyes, ScanReport& report) {
  const std::vector<LengthUnit> units = unitsThatFit(eyes, smallestEyeDistance, largestEyeDistance);
  if (units.empty())
    return "the outer eye corners (landmarks 36 and 45) lie " + roundedText(eyes) +
           " apart, which no head has in mm, cm, m or inches" + askForUnit(eyes > 0.0 ? usualEyes / eyes : 0.0);
  useUnit(units.front(), report);
  return {};
}

/// The largest part alone: skin without eyeballs and stray pieces.
TriangleMesh skinOf(const TriangleMesh& mesh, const MeshParts& parts) {
  std::vector<bool> wanted(static_cast<size_t>(parts.count()), false);
  wanted[0] = true;
  return withParts(mesh, parts, wanted);
}

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
  FaceSearch(const FaceTemplate& reference, const TriangleMesh& skin, const ScanSettings& settings)
      : reference_(reference), skin_(skin), settings_(settings) {}

  std::string find(Trial& best, const Progress& progress) {
    const double size = boxDiagonal(skin_);
    std::vector<LengthUnit> units = unitsOfSize(size);
    if (settings_.millimetres > 0.0) units = {{"", "", settings_.millimetres}};
    if (units.empty()) return describeSize(size) + askForUnit(0.0);
    for (size_t i = 0; i < units.size(); ++i) {
      const double n = static_cast<double>(units.size());
      Trial trial{units[i], {}};
      if (!fit(trial, partOf(progress, static_cast<double>(i) / n, static_cast<double>(i + 1) / n))) return stopped;
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
             (settings_.millimetres > 0.0
                  ? ", or look at the unit: 1 was taken as " + roundedText(settings_.millimetres) + " mm, as asked for"
                  : std::string(", or the unit with --units"));
    if (trials_.size() > 1 && trials_[1].isFace() && trials_[1].score() < clearlyBetter * best.score())
      return "the scan may be in " + best.unit.fullName + " or in " + trials_[1].unit.fullName + askForUnit(0.0);
    return {};
  }

  const FaceTemplate& reference_;
  const TriangleMesh& skin_;
  const ScanSettings& settings_;
  std::vector<Trial> trials_;
};

/// The steps of acquireScan over what they share.
class Acquisition {
 public:
  Acquisition(const CleanMesh& scan, const FaceTemplate& reference, const ScanSettings& settings, AcquiredScan& result)
      : scan_(scan.mesh),
        reference_(reference),
        settings_(settings),
        result_(result),
        report_(result.report),
        parts_(partsOf(scan.mesh)) {
    report_.mergedVertices = scan.mergedVertices;
    report_.degenerateTriangles = scan.degenerateTriangles;
    report_.parts = parts_.count();
    report_.millimetres = settings.millimetres;
    for (const LengthUnit& unit : lengthUnits())
      if (unit.millimetres == settings.millimetres) report_.unit = unit.name;
  }

  std::string place(const LandmarkTable::Given& given, const FaceLandmarks& landmarks) {
    report_.landmarksGiven = true;
    result_.landmarks = landmarks;
    report_.completedLandmarks = static_cast<int>(std::count(given.begin(), given.end(), false));
    const std::string fault = completeLandmarks(reference_.landmarks, given, result_.landmarks);
    if (!fault.empty()) return fault;
    return describeShape();
  }

  /// The unit of given landmarks, and whether they lie on the scan.
  std::string scaleGiven(const LandmarkTable::Given& given) {
    const std::string fault =
        report_.millimetres > 0.0 ? std::string() : recogniseUnit(eyeDistance(result_.landmarks), report_);
    return fault.empty() ? describeDepth(given) : fault;
  }

  /// Landmarks by fitting, in the scan's unit and frame.
  std::string fit(FaceLandmarks& fitted, const Progress& progress) {
    TriangleMesh skin = skinOf(scan_, parts_);
    ScanSettings known = settings_;
    if (report_.landmarksGiven) known.millimetres = report_.millimetres;
    Trial best;
    const std::string fault = FaceSearch(reference_, skin, known).find(best, partOf(progress, 0.0, 0.8));
    if (!fault.empty()) return fault;
    if (!(known.millimetres > 0.0)) useUnit(best.unit, report_);
    report_.fitted = true;
    report_.fitDistance = best.fit.distance;
    report_.fitRelief = best.fit.relief;
    report_.fitSize = best.fit.faceToScan.scale;
    skin.vertices *= report_.millimetres;
    FaceRegistration registration;
    if (!registerFace(reference_, best.fit.faceToScan, skin, registration, partOf(progress, 0.8, 1.0)).empty())
      return stopped;
    fitted = reference_.landmarksOn(registration.points);
    fitted.points /= report_.millimetres;
    return {};
  }

  /// What cannot be compared is no fault of the acquisition, only a remark.
  std::string compare(const Progress& progress) {
    FaceLandmarks fitted;
    const std::string fault = fit(fitted, progress);
    if (fault == stopped) return fault;
    report_.uncomparedReason = fault.substr(0, fault.find(';'));  // without the advice to give landmarks
    if (fault.empty()) compareWith(fitted);
    return {};
  }

  void compareWith(const FaceLandmarks& fitted) {
    const Eigen::VectorXd distances = report_.millimetres * (fitted.points - result_.landmarks.points).rowwise().norm();
    report_.landmarkRMS = std::sqrt(distances.squaredNorm() / FaceLandmarks::count);
    report_.landmarkMaximum = distances.maxCoeff();
  }

  /// From the scan's unit and frame to those of a face.
  void normalise() {
    const Similarity::Points places = report_.millimetres * result_.landmarks.points;
    const Eigen::VectorXd weights = Eigen::VectorXd::Ones(FaceLandmarks::count);
    const Similarity motion = fitSimilarity(places, reference_.landmarks.points, weights, true);
    report_.turned = Eigen::AngleAxisd(motion.rotation).angle();
    const double away = (places.colwise().mean() - reference_.landmarks.points.colwise().mean()).norm();
    report_.moved =
        settings_.pose == ScanSettings::Pose::Moved ||
        (settings_.pose == ScanSettings::Pose::Automatic && (report_.turned > uprightWithin || away > nearWithin));
    report_.scanToFace.scale = report_.millimetres;
    if (report_.moved) {
      report_.scanToFace.rotation = motion.rotation;
      report_.scanToFace.translation = motion.translation;
    }
    result_.mesh = scan_;
    if (report_.moved || report_.millimetres != 1.0) {
      result_.mesh.vertices = report_.scanToFace.applied(scan_.vertices);
      result_.landmarks.points = report_.scanToFace.applied(result_.landmarks.points);
    }
    report_.eyes = eyeDistance(result_.landmarks);
  }

  /// Keeps the skin and what lies in its eye sockets.
  void dropParts() {
    std::vector<bool> wanted(static_cast<size_t>(parts_.count()), settings_.allParts);
    wanted[0] = true;
    for (int part = 1; part < parts_.count(); ++part)
      if (liesInEye(report_.scanToFace(parts_.middle[part]), report_.millimetres * parts_.size[part]))
        wanted[part] = true;
    report_.droppedParts = static_cast<int>(std::count(wanted.begin(), wanted.end(), false));
    if (report_.droppedParts > 0) result_.mesh = withParts(result_.mesh, parts_, wanted);
    report_.triangles = static_cast<int>(result_.mesh.triangles.rows());
    report_.holes = boundaryLoops(skinOf(scan_, parts_));
  }

  std::string measure() {
    const std::string fault =
        acquireFace(result_.mesh, result_.landmarks, settings_.pointsPerCurve, result_.face, settings_.nostrils);
    if (fault.empty() || report_.droppedParts == 0) return fault;
    return fault + " (" + std::to_string(report_.droppedParts) +
           " loose parts of the scan were left out; --all-parts keeps them)";
  }

 private:
  bool liesInEye(const Eigen::Vector3d& middle, double size) const {
    const double eyes = eyeDistance(result_.landmarks);
    for (const int corner : {36, 42}) {
      const Eigen::Vector3d eye = 0.5 * (result_.landmarks[corner] + result_.landmarks[corner + 3]);
      if ((middle - eye).norm() < 0.25 * eyes && size < 0.7 * eyes) return true;
    }
    return false;
  }

  /// Places in another order, or vertices of another mesh, are no face in any pose and size.
  std::string describeShape() const {
    const Similarity::Points& places = result_.landmarks.points;
    const Similarity motion =
        fitSimilarity(places, reference_.landmarks.points, Eigen::VectorXd::Ones(FaceLandmarks::count), false);
    const double misfit =
        std::sqrt((motion.applied(places) - reference_.landmarks.points).rowwise().squaredNorm().mean());
    if (misfit <= largestLandmarkMisfit) return {};
    return "the landmarks do not lie as those of a face do: in the best pose and size they are " + roundedText(misfit) +
           " mm (RMS) from the generic ones (at most " + roundedText(largestLandmarkMisfit) +
           " are allowed); check their numbers, and whether vertices are those of this mesh";
  }

  std::string describeDepth(const LandmarkTable::Given& given) {
    std::vector<double> depths;
    for (int i = 0; i < FaceLandmarks::count; ++i)
      if (given[i]) depths.push_back(report_.millimetres * distanceTo(scan_, result_.landmarks[i]));
    const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
    std::nth_element(depths.begin(), middle, depths.end());
    report_.landmarkDepth = *middle;
    if (*middle <= deepestLandmarks) return {};
    return "the landmarks lie " + roundedText(*middle) + " mm (median) off the scan (at most " +
           roundedText(deepestLandmarks) +
           " are allowed); give landmarks of this scan, in its unit and frame, or leave them out to have them fitted";
  }

  const TriangleMesh& scan_;
  const FaceTemplate& reference_;
  const ScanSettings& settings_;
  AcquiredScan& result_;
  ScanReport& report_;
  MeshParts parts_;
};

}  // namespace

std::string recogniseScanUnit(const CleanMesh& scan, const FaceTemplate& reference, std::vector<LengthUnit>& fitting,
                              const Progress& progress) {
  const TriangleMesh skin = skinOf(scan.mesh, partsOf(scan.mesh));
  fitting = unitsOfSize(boxDiagonal(skin));
  if (fitting.empty()) return describeSize(boxDiagonal(skin));
  if (fitting.size() == 1) return {};
  Trial best;
  const std::string fault = FaceSearch(reference, skin, ScanSettings()).find(best, progress);
  if (fault.empty()) fitting = {best.unit};
  return fault;
}

std::string acquireScan(const CleanMesh& scan, const LandmarkTable::Given& given, const FaceLandmarks& landmarks,
                        const FaceTemplate& reference, const ScanSettings& settings, AcquiredScan& acquired,
                        const Progress& progress) {
  const std::string meshFault = describeFault(scan.mesh);
  if (!meshFault.empty()) return meshFault;
  AcquiredScan result;
  Acquisition acquisition(scan, reference, settings, result);
  const bool known = any(given);
  std::string fault =
      known ? acquisition.place(given, landmarks) : acquisition.fit(result.landmarks, partOf(progress, 0.0, 0.9));
  if (fault.empty() && known) fault = acquisition.scaleGiven(given);
  if (fault.empty() && known && settings.compareLandmarks) fault = acquisition.compare(partOf(progress, 0.0, 0.9));
  if (!fault.empty()) return fault;
  acquisition.normalise();
  acquisition.dropParts();
  if (!goesOn(progress, 0.92)) return stopped;
  fault = acquisition.measure();
  if (fault.empty()) acquired = std::move(result);
  return fault;
}

}  // namespace mien
