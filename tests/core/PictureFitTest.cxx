#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "FaceAcquisition.h"
#include "FaceLayout.h"
#include "PictureFit.h"
#include "SyntheticHead.h"

using namespace mien;

namespace {

struct Known {
  FaceLandmarks landmarks = ellipticHead().landmarks();
  FaceCurves face;

  Known() { EXPECT_EQ(acquireFace(ellipticHead().mesh(), landmarks, 40, face), ""); }
};

const Known& known() {
  static const Known face;
  return face;
}

/// Another face: wider below, with higher brows and a longer chin.
FaceLandmarks otherFace() {
  FaceLandmarks landmarks = known().landmarks;
  for (int i = 0; i < FaceLandmarks::count; ++i) {
    const double y = landmarks.points(i, 1);
    landmarks.points(i, 0) *= 1.05 - 0.0006 * y;
    landmarks.points(i, 1) += 0.0006 * y * y;
  }
  return landmarks;
}

FaceLandmarks pictureOf(const FaceLandmarks& face, double pixels, double turn, bool yDown) {
  const Eigen::Rotation2Dd rotation(turn);
  FaceLandmarks picture;
  for (int i = 0; i < FaceLandmarks::count; ++i) {
    const Eigen::Vector2d p = pixels * (rotation * face[i].head<2>()) + Eigen::Vector2d(900.0, 700.0);
    picture.points.row(i) << p.x(), yDown ? -p.y() : p.y(), 0.0;
  }
  return picture;
}

std::string fit(const FaceLandmarks& picture, FaceCurves& face, PictureReport& report,
                const PictureSettings& settings = {}) {
  return fitToPicture(known().face, known().landmarks, picture, settings, face, report);
}

}  // namespace

TEST(PictureFit, ThePictureOfTheKnownFaceGivesItBack) {
  FaceCurves face;
  PictureReport report;
  ASSERT_EQ(fit(pictureOf(known().landmarks, 4.2, 0.0, true), face, report), "");
  EXPECT_TRUE(report.yDown);
  EXPECT_NEAR(report.millimetres, 1.0 / 4.2, 1e-12);
  EXPECT_LT((face.curves.points - known().face.curves.points).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_LT((face.leftPupil - known().face.leftPupil).norm(), 1e-8);
}

TEST(PictureFit, LandmarksOfAnotherFaceAreMet) {
  for (const bool yDown : {true, false}) {
    FaceCurves face;
    PictureReport report;
    PictureSettings settings;
    settings.millimetres = 0.5;
    const FaceLandmarks other = otherFace();
    ASSERT_EQ(fit(pictureOf(other, 2.0, 0.0, yDown), face, report, settings), "");
    EXPECT_EQ(report.yDown, yDown);
    EXPECT_LT(report.residual, 1e-8);
    const Eigen::RowVector2d shift = (report.landmarks.points - other.points).leftCols(2).colwise().mean();
    EXPECT_LT(((report.landmarks.points - other.points).leftCols(2).rowwise() - shift).cwiseAbs().maxCoeff(), 1e-6)
        << "x and y follow the picture";
    // a curve that passes a landmark passes it still: the nose tip on C15
    const Eigen::Vector3d tip = face.curves.at(FaceLayout::curveIndex("C15"), M_PI);
    EXPECT_NEAR(tip.x(), report.landmarks[30].x(), 0.05);
    EXPECT_NEAR(tip.y(), report.landmarks[30].y(), 0.05);
  }
}

TEST(PictureFit, ATiltedHeadIsSetUprightOrKept) {
  FaceCurves upright, tilted;
  PictureReport report;
  PictureSettings keep;
  keep.upright = false;
  const FaceLandmarks picture = pictureOf(known().landmarks, 3.0, 0.2, true);
  ASSERT_EQ(fit(picture, upright, report), "");
  EXPECT_NEAR(report.tilt, 0.2, 1e-9);
  EXPECT_LT((upright.curves.points - known().face.curves.points).cwiseAbs().maxCoeff(), 1e-7);
  ASSERT_EQ(fit(pictureOf(known().landmarks, 3.0, 0.02, true), tilted, report, keep), "");
  EXPECT_GT((tilted.curves.points - known().face.curves.points).cwiseAbs().maxCoeff(), 1.0);
}

TEST(PictureFit, SymmetricFacesStaySymmetric) {
  FaceLandmarks crooked = known().landmarks;
  crooked.points.row(48) += Eigen::RowVector3d(-3.0, 2.0, 0.0);
  FaceCurves face;
  PictureReport report;
  PictureSettings settings;
  settings.symmetric = true;
  ASSERT_EQ(fit(pictureOf(crooked, 3.0, 0.0, true), face, report, settings), "");
  const FaceCurves mirror = symmetrised(face);
  EXPECT_LT((face.curves.points - mirror.curves.points).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(PictureFit, WhatIsNoFaceIsRefusedAndLeavesTheFaceAlone) {
  FaceCurves face;
  PictureReport report;
  std::srand(5);
  FaceLandmarks random, line, mirrored = pictureOf(known().landmarks, 3.0, 0.0, true), swapped = mirrored;
  random.points.setRandom();
  for (int i = 0; i < FaceLandmarks::count; ++i) line.points.row(i) << i, 2 * i, 0;
  EXPECT_NE(fit(random, face, report).find("no frontal face"), std::string::npos);
  EXPECT_NE(fit(line, face, report), "");
  EXPECT_NE(fit(FaceLandmarks(), face, report), "");
  mirrored.points.col(0) *= -1.0;
  EXPECT_NE(fit(mirrored, face, report).find("mirror"), std::string::npos) << fit(mirrored, face, report);
  swapped.points.row(30).swap(swapped.points.row(8));
  EXPECT_NE(fit(swapped, face, report), "");
  EXPECT_EQ(face.curves.count, 0);
}
