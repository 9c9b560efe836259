#include "ScanAcquisition.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "FaceAcquisition.h"
#include "FaceRegistration.h"
#include "FaceSearch.h"
#include "NumberText.h"
#include "RadialSkin.h"
#include "TriangleDistance.h"

namespace mien {

namespace {

// Bounds of what is taken for a face: doc/decisions.md.
constexpr double uprightWithin = 10.0 * M_PI / 180.0, nearWithin = 60.0;  // mm
constexpr double usualEyes = 90.0;                                        // mm
constexpr double deepestLandmarks = 2.0;                                  // mm, median
constexpr double largestLandmarkMisfit = 20.0;                            // mm RMS
constexpr double leastTurned = 0.5;  // share of the skin around the face, of that seen from before it

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
    if (!fault.empty()) return fault;
    report_.landmarkDepth = depthOver(scan_, given);
    if (!(report_.landmarkDepth <= deepestLandmarks)) return describeDepth();
    for (const int part : largeParts(parts_)) {
      report_.facePart = part;
      if (depthOver(partAlone(scan_, parts_, part), given) <= deepestLandmarks) return {};
    }
    report_.facePart = 0;
    return {};
  }

  /// Landmarks by fitting, in the scan's unit and frame.
  std::string fit(FaceLandmarks& fitted, const Progress& progress) {
    const double millimetres = report_.landmarksGiven ? report_.millimetres : settings_.millimetres;
    FoundFace best;
    const std::string fault = findFace(scan_, parts_, reference_, millimetres, best, partOf(progress, 0.0, 0.8));
    if (!fault.empty()) return fault;
    if (!(millimetres > 0.0)) useUnit(best.unit, report_);
    if (!report_.landmarksGiven) report_.facePart = best.part;
    report_.fitted = true;
    report_.fitDistance = best.fit.distance;
    report_.fitRelief = best.fit.relief;
    report_.fitSize = best.fit.faceToScan.scale;
    TriangleMesh skin = partAlone(scan_, parts_, best.part);
    skin.vertices *= report_.millimetres;
    FaceRegistration registration;
    if (!registerFace(reference_, best.fit.faceToScan, skin, registration, partOf(progress, 0.8, 1.0)).empty())
      return searchStopped;
    fitted = reference_.landmarksOn(registration.points);
    fitted.points /= report_.millimetres;
    return {};
  }

  /// What cannot be compared is no fault of the acquisition, only a remark.
  std::string compare(const Progress& progress) {
    FaceLandmarks fitted;
    const std::string fault = fit(fitted, progress);
    if (fault == searchStopped) return fault;
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
    report_.windsInwards = windsInwards(motion.rotation.row(2).transpose());
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
    wanted[report_.facePart] = true;
    for (int part = 0; part < parts_.count(); ++part)
      if (liesInEye(report_.scanToFace(parts_.middle[part]), report_.millimetres * parts_.size[part]))
        wanted[part] = true;
    report_.droppedParts = static_cast<int>(std::count(wanted.begin(), wanted.end(), false));
    if (report_.droppedParts > 0) result_.mesh = withParts(result_.mesh, parts_, wanted);
    report_.triangles = static_cast<int>(result_.mesh.triangles.rows());
    report_.holes = boundaryLoops(partAlone(scan_, parts_, report_.facePart));
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

  /// RMS distance from the reference's landmarks in the best pose and size, mm.
  double misfitOf(const Similarity::Points& places) const {
    const Eigen::VectorXd weights = Eigen::VectorXd::Ones(FaceLandmarks::count);
    const Similarity motion = fitSimilarity(places, reference_.landmarks.points, weights, false);
    return std::sqrt((motion.applied(places) - reference_.landmarks.points).rowwise().squaredNorm().mean());
  }

  /// Places in another order, or vertices of another mesh, are no face in any pose and size.
  std::string describeShape() const {
    Similarity::Points places = result_.landmarks.points;
    const double misfit = misfitOf(places);
    if (misfit <= largestLandmarkMisfit) return {};
    places.col(0) *= -1.0;
    const double mirrored = misfitOf(places);
    if (mirrored <= largestLandmarkMisfit)
      return "the landmarks are those of a mirrored face (in the best pose and size they are " + roundedText(misfit) +
             " mm RMS from the generic ones, mirrored " + roundedText(mirrored) +
             "): the scan is left-handed, or left and right are exchanged; turn one axis of the scan round, or give "
             "landmarks whose left is the subject's own";
    return "the landmarks do not lie as those of a face do: in the best pose and size they are " + roundedText(misfit) +
           " mm (RMS) from the generic ones (at most " + roundedText(largestLandmarkMisfit) +
           " are allowed); check their numbers, and whether vertices are those of this mesh";
  }

  /// Median distance of the given landmarks, mm.
  double depthOver(const TriangleMesh& mesh, const LandmarkTable::Given& given) const {
    std::vector<double> depths;
    for (int i = 0; i < FaceLandmarks::count; ++i)
      if (given[i]) depths.push_back(report_.millimetres * distanceTo(mesh, result_.landmarks[i]));
    const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
    std::nth_element(depths.begin(), middle, depths.end());
    return *middle;
  }

  std::string describeDepth() const {
    return "the landmarks lie " + roundedText(report_.landmarkDepth) + " mm (median) off the scan (at most " +
           roundedText(deepestLandmarks) +
           " are allowed); give landmarks of this scan, in its unit and frame, or leave them out to have them fitted";
  }

  /// Whether most of the skin around the landmarks turns its back on who looks at the face.
  bool windsInwards(const Eigen::Vector3d& forwards) const {
    const Eigen::RowVector3d middle = result_.landmarks.points.colwise().mean();
    const double reach = (result_.landmarks.points.rowwise() - middle).rowwise().norm().maxCoeff();
    double turned = 0.0, all = 0.0;
    for (int t = 0; t < scan_.triangles.rows(); ++t) {
      const auto corner = [&](int i) { return scan_.vertices.row(scan_.triangles(t, i)); };
      if ((corner(0) - middle).norm() > reach) continue;
      const double seen = (corner(1) - corner(0)).cross(corner(2) - corner(0)).dot(forwards.transpose());
      turned += seen;
      all += std::abs(seen);
    }
    return turned < -leastTurned * all;
  }

  const TriangleMesh& scan_;
  const FaceTemplate& reference_;
  const ScanSettings& settings_;
  AcquiredScan& result_;
  ScanReport& report_;
  MeshParts parts_;
};

}  // namespace

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
  if (!goesOn(progress, 0.92)) return searchStopped;
  fault = acquisition.measure();
  if (fault.empty()) acquired = std::move(result);
  return fault;
}

}  // namespace mien
