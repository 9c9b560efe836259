#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "DenseFace.h"
#include "FaceAcquisition.h"
#include "FaceLayout.h"
#include "ScanAcquisition.h"
#include "SyntheticHead.h"
#include "vtkCellArray.h"
#include "vtkCellLocator.h"
#include "vtkGenericCell.h"
#include "vtkPoints.h"

using namespace mien;

namespace {

LandmarkTable::Given all() {
  LandmarkTable::Given given;
  given.fill(true);
  return given;
}

/// Distances to the known surface, on a mesh four times as fine.
class KnownSurface {
 public:
  KnownSurface() {
    const TriangleMesh mesh = DenseFace::surface(441, 443);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (int i = 0; i < mesh.vertices.rows(); ++i) points->InsertNextPoint(mesh.vertices.row(i).data());
    vtkNew<vtkCellArray> cells;
    for (int t = 0; t < mesh.triangles.rows(); ++t) {
      const vtkIdType ids[3] = {mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2)};
      cells->InsertNextCell(3, ids);
    }
    data_->SetPoints(points);
    data_->SetPolys(cells);
    locator_->SetDataSet(data_);
    locator_->BuildLocator();
  }

  double rms(const ClosedCurves::Points& points) const {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      double nearest[3], squared = 0.0;
      vtkIdType cell;
      int sub;
      locator_->FindClosestPoint(points.row(i).data(), nearest, cell, sub, squared);
      sum += squared;
    }
    return std::sqrt(sum / static_cast<double>(points.rows()));
  }

 private:
  vtkNew<vtkPolyData> data_;
  vtkNew<vtkCellLocator> locator_;
};

const KnownSurface& known() {
  static const KnownSurface surface;
  return surface;
}

AcquiredScan acquired(const DenseFace& scan, const LandmarkTable::Given& given, const ScanSettings& settings = {}) {
  AcquiredScan result;
  EXPECT_EQ(acquireScan(cleaned(scan.mesh), given, scan.landmarks, referenceTemplate(), settings, result), "");
  return result;
}

/// RMS distance of the curves to the known surface, where the scan was before it was moved by `motion`.
double distanceOf(const AcquiredScan& scan, const Similarity& motion = {}) {
  return known().rms(motion.inverse().applied(scan.report.scanToFace.inverse().applied(scan.face.curves.points)));
}

Similarity someMotion(double scale) {
  return {scale,
          Eigen::AngleAxisd(2.1, Eigen::Vector3d(1.0, -0.4, 0.7).normalized()).toRotationMatrix(),
          {310.0 * scale, -95.0 * scale, 42.0 * scale}};
}

DenseFace movedFace(const Similarity& motion) {
  DenseFace scan;
  scan.mesh.vertices = motion.applied(scan.mesh.vertices);
  scan.landmarks.points = motion.applied(scan.landmarks.points);
  return scan;
}

TriangleMesh sphere() {
  SyntheticHead head;
  head.radius = [](double, double y) { return std::sqrt(std::max(1.0, 115.0 * 115.0 - y * y)); };
  return head.mesh(-114, 114);
}

std::string faultWithout(const TriangleMesh& mesh, const ScanSettings& settings = {}) {
  AcquiredScan result;
  return acquireScan(cleaned(mesh), {}, {}, referenceTemplate(), settings, result);
}

}  // namespace

TEST(ScanAcquisition, CurvesLieOnTheKnownSurface) {
  const DenseFace scan;
  EXPECT_NEAR(static_cast<double>(scan.mesh.triangles.rows()), 100000.0, 2000.0);
  const AcquiredScan result = acquired(scan, all());
  RecordProperty("rms_um", static_cast<int>(1000 * distanceOf(result)));
  EXPECT_LT(distanceOf(result), 0.05);
  EXPECT_FALSE(result.report.moved);
  EXPECT_EQ(result.report.scanToFace.rotation, Eigen::Matrix3d::Identity());
}

TEST(ScanAcquisition, ARigidMoveChangesNothing) {
  const Similarity motion = someMotion(1.0);
  const AcquiredScan result = acquired(movedFace(motion), all());
  EXPECT_TRUE(result.report.moved);
  EXPECT_LT(distanceOf(result, motion), 0.05);
}

TEST(ScanAcquisition, SmallHolesAreFilled) {
  DenseFace scan;
  scan.makeHoles(25, 2.5);  // holes of 8 mm, on nose and lids too, give 0.059 mm
  const AcquiredScan result = acquired(scan, all());
  EXPECT_GT(result.report.holes, 15);
  EXPECT_LT(distanceOf(result), 0.05);
}

TEST(ScanAcquisition, NoiseOfATenthOfAMillimetreIsNotMagnified) {
  DenseFace scan;
  scan.addNoise(0.1);
  EXPECT_LT(distanceOf(acquired(scan, all())), 0.15);
}

TEST(ScanAcquisition, UnitsAreRecognisedByTheEyes) {
  for (const auto& [unit, scale] : {std::pair{"mm", 1.0}, {"cm", 0.1}, {"m", 0.001}, {"inch", 1.0 / 25.4}}) {
    DenseFace scan(60, 61);
    scan.mesh.vertices *= scale;
    scan.landmarks.points *= scale;
    const AcquiredScan result = acquired(scan, all());
    EXPECT_EQ(result.report.unit, unit);
    EXPECT_TRUE(result.report.unitRecognised);
    EXPECT_NEAR(result.report.eyes, eyeDistance(referenceLandmarks()), 2.0);
  }
}

TEST(ScanAcquisition, UnitsAreRecognisedWithoutLandmarks) {
  for (const auto& [unit, scale] : {std::pair{"cm", 0.1}, {"inch", 1.0 / 25.4}}) {
    DenseFace scan(80, 81);
    scan.mesh.vertices *= scale;
    const AcquiredScan result = acquired(scan, {});
    EXPECT_EQ(result.report.unit, unit);
    EXPECT_TRUE(result.report.unitRecognised);
    EXPECT_NEAR(result.report.eyes, eyeDistance(referenceLandmarks()), 3.0);
  }
}

TEST(ScanAcquisition, ASizeBetweenTwoUnitsIsAskedAbout) {
  DenseFace scan(80, 81);
  scan.mesh.vertices *= 0.1 / std::sqrt(2.54);  // in cm too small a head, in inches too large a one
  const std::string fault = faultWithout(scan.mesh);
  EXPECT_NE(fault.find("or the unit with --units"), std::string::npos) << fault;
}

TEST(ScanAcquisition, AnImpossibleSizeIsAskedAbout) {
  DenseFace scan(60, 61);
  scan.mesh.vertices *= 0.02;
  scan.landmarks.points *= 0.02;
  AcquiredScan result;
  const std::string fault = acquireScan(cleaned(scan.mesh), all(), scan.landmarks, referenceTemplate(), {}, result);
  EXPECT_NE(fault.find("--units"), std::string::npos) << fault;
  EXPECT_NE(fault.find("--scale"), std::string::npos) << fault;
  EXPECT_EQ(result.face.curves.count, 0);
  ScanSettings settings;
  settings.millimetres = 50.0;
  EXPECT_LT(distanceOf(acquired(scan, all(), settings), {0.02, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()}),
            0.5);
}

TEST(ScanAcquisition, TwelveLandmarksAreEnough) {
  const DenseFace scan;
  LandmarkTable::Given given{};
  for (int i = 0; i < FaceLandmarks::count; ++i) given[i] = !landmarkName(i).empty();
  const AcquiredScan result = acquired(scan, given);
  EXPECT_EQ(result.report.completedLandmarks, 56);
  EXPECT_LT((result.landmarks.points - scan.landmarks.points).rowwise().norm().maxCoeff(), 3.0)
      << "the reference's own lie up to 2.2 mm off its surface";
  EXPECT_LT(distanceOf(result), 0.1);
}

TEST(ScanAcquisition, LandmarksMustBeThoseOfTheScan) {
  const DenseFace scan(110, 111);
  const auto faultOf = [&](const FaceLandmarks& landmarks) {
    AcquiredScan result;
    return acquireScan(cleaned(scan.mesh), all(), landmarks, referenceTemplate(), {}, result);
  };
  EXPECT_EQ(faultOf(scan.landmarks), "");
  FaceLandmarks other = scan.landmarks;
  other.points.col(2).array() += 4.0;
  EXPECT_NE(faultOf(other).find("off the scan"), std::string::npos) << faultOf(other);
  other.points = 0.1 * scan.landmarks.points;  // cm beside a scan in mm
  EXPECT_NE(faultOf(other).find("off the scan"), std::string::npos) << faultOf(other);
  other.points = scan.landmarks.points.colwise().reverse();
  EXPECT_NE(faultOf(other).find("as those of a face do"), std::string::npos) << faultOf(other);
}

TEST(ScanAcquisition, LandmarksThatCannotBeComparedAreARemark) {
  const SyntheticHead head = ellipticHead();
  ScanSettings settings;
  settings.compareLandmarks = true;
  AcquiredScan result;
  ASSERT_EQ(acquireScan(cleaned(head.mesh()), all(), head.landmarks(), referenceTemplate(), settings, result), "");
  EXPECT_EQ(result.report.uncomparedReason.rfind("no face was found", 0), 0u) << result.report.uncomparedReason;
  EXPECT_FALSE(result.report.fitted);
  EXPECT_EQ(result.face.curves.count, 29);
}

TEST(ScanAcquisition, FindsUnitPoseAndLandmarksByItself) {
  const Similarity motion = someMotion(0.001);
  const AcquiredScan result = acquired(movedFace(motion), {});
  EXPECT_EQ(result.report.unit, "m");
  EXPECT_TRUE(result.report.fitted);
  EXPECT_LT(distanceOf(result, motion), 0.1);
  const FaceLandmarks expected = DenseFace::onSurface();
  const Eigen::VectorXd distances = (result.landmarks.points - expected.points).rowwise().norm();
  EXPECT_LT(std::sqrt(distances.squaredNorm() / 68), 2.0);
  EXPECT_LT((result.report.scanToFace.rotation * motion.rotation - Eigen::Matrix3d::Identity()).norm(), 0.03);
}

TEST(ScanAcquisition, WhatIsNoFaceIsRefused) {
  EXPECT_NE(faultWithout(sphere()).find("no face"), std::string::npos) << faultWithout(sphere());
  EXPECT_NE(faultWithout(ellipticHead().mesh()).find("no face"), std::string::npos);
  TriangleMesh noise = sphere();
  for (int i = 0; i < noise.vertices.rows(); ++i) noise.vertices.row(i) *= 1.0 + 0.1 * std::sin(12.9898 * i);
  EXPECT_NE(faultWithout(noise).find("no face"), std::string::npos);
}

TEST(ScanAcquisition, StrayPartsGoAndEyeballsStay) {
  DenseFace scan(120, 121);
  const int before = static_cast<int>(scan.mesh.triangles.rows());
  const auto addBall = [&scan](const Eigen::RowVector3d& middle, double radius) {
    SyntheticHead ball;
    ball.axis = {0.0, 0.0};
    ball.radius = [](double, double y) { return std::sqrt(std::max(0.01, 10.0 * 10.0 - y * y)); };
    TriangleMesh more = ball.mesh(-10, 10);
    const int first = static_cast<int>(scan.mesh.vertices.rows()),
              triangles = static_cast<int>(scan.mesh.triangles.rows());
    scan.mesh.vertices.conservativeResize(first + more.vertices.rows(), 3);
    scan.mesh.vertices.bottomRows(more.vertices.rows()) = (more.vertices * (radius / 10.0)).rowwise() + middle;
    scan.mesh.triangles.conservativeResize(triangles + more.triangles.rows(), 3);
    scan.mesh.triangles.bottomRows(more.triangles.rows()) = more.triangles.array() + first;
  };
  const Eigen::RowVector3d eye = 0.5 * (scan.landmarks.points.row(42) + scan.landmarks.points.row(45));
  addBall(eye - Eigen::RowVector3d(0.0, 0.0, 13.0), 12.0);
  addBall(Eigen::RowVector3d(60.0, 0.0, 160.0), 8.0);
  const AcquiredScan result = acquired(scan, all());
  EXPECT_EQ(result.report.parts, 3);
  EXPECT_EQ(result.report.droppedParts, 1);
  EXPECT_GT(result.report.triangles, before);
  EXPECT_LT(distanceOf(result), 0.2);
}

TEST(ScanAcquisition, TheFaceIsFoundBesideAFloorThatIsLarger) {
  DenseFace scan(110, 111);
  const int first = static_cast<int>(scan.mesh.vertices.rows()),
            triangles = static_cast<int>(scan.mesh.triangles.rows());
  scan.mesh.vertices.conservativeResize(first + 4, 3);
  scan.mesh.vertices.bottomRows(4) << -600, -180, -600, 600, -180, -600, 600, -180, 600, -600, -180, 600;
  scan.mesh.triangles.conservativeResize(triangles + 2, 3);
  scan.mesh.triangles.bottomRows(2) << first, first + 3, first + 2, first, first + 2, first + 1;
  for (const LandmarkTable::Given& given : {LandmarkTable::Given{}, all()}) {
    const AcquiredScan result = acquired(scan, given), alone = acquired(DenseFace(110, 111), given);
    EXPECT_EQ(result.report.parts, 2);
    EXPECT_EQ(result.report.facePart, 1);
    EXPECT_EQ(result.report.droppedParts, 1);
    EXPECT_EQ(alone.report.facePart, 0);
    EXPECT_EQ(result.report.triangles, alone.report.triangles);
    EXPECT_LT((result.face.curves.points - alone.face.curves.points).cwiseAbs().maxCoeff(), 1e-6) << "mm";
  }
  TriangleMesh other = sphere();
  other.vertices.conservativeResize(other.vertices.rows() + 3, 3);
  other.vertices.bottomRows(3) << 0, 300, 0, 9, 300, 0, 0, 300, 9;
  other.triangles.conservativeResize(other.triangles.rows() + 1, 3);
  const int last = static_cast<int>(other.vertices.rows()) - 1;
  other.triangles.bottomRows(1) << last - 2, last - 1, last;
  EXPECT_NE(faultWithout(other).find("(of its 2 parts only the largest was searched"), std::string::npos)
      << faultWithout(other);
}

TEST(ScanAcquisition, FacesThatWindInwardsAndMirroredLandmarksAreTold) {
  DenseFace scan(110, 111);
  EXPECT_FALSE(acquired(scan, {}).report.windsInwards);
  EXPECT_FALSE(acquired(scan, all()).report.windsInwards);
  DenseFace turned(110, 111);
  turned.mesh.triangles.col(0).swap(turned.mesh.triangles.col(1));
  EXPECT_TRUE(acquired(turned, all()).report.windsInwards);
  scan.mesh.vertices.col(0) *= -1.0;
  scan.landmarks.points.col(0) *= -1.0;
  EXPECT_TRUE(acquired(scan, {}).report.windsInwards);
  AcquiredScan result;
  const std::string fault = acquireScan(cleaned(scan.mesh), all(), scan.landmarks, referenceTemplate(), {}, result);
  EXPECT_EQ(fault.rfind("the landmarks are those of a mirrored face", 0), 0u) << fault;
}

TEST(ScanAcquisition, StopsWhenAsked) {
  const DenseFace scan(60, 61);
  AcquiredScan result;
  double last = -1.0;
  const std::string fault =
      acquireScan(cleaned(scan.mesh), {}, {}, referenceTemplate(), {}, result, [&last](double done) {
        EXPECT_GE(done, last);
        last = done;
        return done < 0.3;
      });
  EXPECT_NE(fault.find("stopped"), std::string::npos);
  EXPECT_LT(last, 0.35);
}
