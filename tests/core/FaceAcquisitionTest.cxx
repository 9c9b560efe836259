#include <gtest/gtest.h>

#include "Degree.h"
#include "FaceAcquisition.h"
#include "FaceLayout.h"
#include "SyntheticHead.h"

using namespace mien;

namespace {

FaceCurves measured(int pointsPerCurve = 40) {
  const SyntheticHead head = ellipticHead();
  FaceCurves face;
  EXPECT_EQ(acquireFace(head.mesh(), head.landmarks(), pointsPerCurve, face), "");
  return face;
}

bool isLipLine(int curve) {
  return curve == FaceLayout::upperLip || curve == FaceLayout::lowerLip;
}

}  // namespace

TEST(FaceAcquisition, PointsOfTheFrontLieOnTheHead) {
  const SyntheticHead head = ellipticHead();
  const FaceCurves face = measured();
  for (int c = 0; c < face.curves.count; ++c)
    for (int j = 10; j <= 30; ++j) {
      const Eigen::Vector3d p = face.curves.curve(c).row(j);
      // lips follow the landmarks between which their radius is interpolated
      EXPECT_NEAR(head.axis.radius(p), head.radius(head.axis.azimuth(p), p.y()), isLipLine(c) ? 0.2 : 0.03)
          << FaceLayout::curveName(c) << " point " << j;
    }
}

TEST(FaceAcquisition, PointsOfTheBackLieWithinTheSmoothing) {
  const SyntheticHead head = ellipticHead();
  const FaceCurves face = measured();
  for (int c = 0; c < face.curves.count; ++c)
    for (int j = -9; j <= 9; ++j) {
      const Eigen::Vector3d p = face.curves.curve(c).row((j + 40) % 40);
      EXPECT_NEAR(head.axis.radius(p), head.radius(head.axis.azimuth(p), p.y()), 0.6) << FaceLayout::curveName(c);
    }
}

TEST(FaceAcquisition, SamplesLieAtTheirAzimuths) {
  const FaceCurves face = measured(64);
  const HeadAxis axis = headAxis(ellipticHead().landmarks());
  EXPECT_EQ(face.curves.pointsPerCurve, 64);
  for (int c = 0; c < face.curves.count; ++c)
    for (int j = 1; j < 64; ++j)
      EXPECT_NEAR(axis.azimuth(face.curves.curve(c).row(j)), sampleAzimuth(2.0 * M_PI * j / 64), 1e-9);
  EXPECT_GT(face.curves.curve(10)(40, 0), 0.0) << "v grows towards the subject's left, +x";
}

TEST(FaceAcquisition, ClosedLipsCoincideAndCurvesDoNotCross) {
  const FaceCurves face = measured();
  EXPECT_EQ(face.curves.curve(FaceLayout::upperLip), face.curves.curve(FaceLayout::lowerLip));
  EXPECT_EQ(describeFault(face), "");
}

TEST(FaceAcquisition, RefusesAHeadWithoutABackAndLeavesTheFaceAlone) {
  const SyntheticHead head = ellipticHead();
  TriangleMesh mask = head.mesh();
  for (int t = 0; t < mask.triangles.rows(); ++t)
    if (mask.vertices.row(mask.triangles(t, 0)).z() < 0.0) mask.triangles.row(t).setConstant(mask.triangles(t, 0));
  FaceCurves face;
  const std::string fault = acquireFace(mask, head.landmarks(), 40, face);
  EXPECT_NE(fault.find("no skin"), std::string::npos) << fault;
  EXPECT_EQ(face.curves.count, 0);
}

TEST(FaceAcquisition, TheMeanOfAFaceAndItsShiftedCopyLiesHalfway) {
  const FaceCurves face = measured();
  FaceCurves shifted = face, mean;
  shifted.curves.points.col(1).array() += 4.0;
  shifted.leftPupil.y() += 4.0;
  ASSERT_EQ(meanFace({face, shifted}, mean), "");
  EXPECT_NEAR((mean.curves.points.col(1) - face.curves.points.col(1)).maxCoeff(), 2.0, 1e-12);
  EXPECT_NEAR(mean.leftPupil.y() - face.leftPupil.y(), 2.0, 1e-12);
  EXPECT_NEAR(mean.features.back().v, face.features.back().v, 1e-12);
}

TEST(FaceAcquisition, TheMeanRefusesFacesOfAnotherKind) {
  const FaceCurves face = measured();
  FaceCurves other = face, mean;
  other.features.pop_back();
  EXPECT_NE(meanFace({face, other}, mean), "");
  EXPECT_NE(meanFace({face, measured(64)}, mean), "");
  EXPECT_NE(meanFace({}, mean), "");
}

TEST(FaceAcquisition, SymmetrisedFacesMirrorToTheLastBit) {
  FaceCurves face = measured();
  for (int i = 0; i < face.curves.points.rows(); ++i) face.curves.points(i, 0) += 0.3 * std::sin(1.7 * i) + 0.2;
  const FaceCurves mirror = symmetrised(face);
  for (int c = 0; c < mirror.curves.count; ++c)
    for (int j = 0; j < 40; ++j) {
      const Eigen::Vector3d p = mirror.curves.curve(c).row(j), q = mirror.curves.curve(c).row((40 - j) % 40);
      EXPECT_EQ(p, Eigen::Vector3d(-q.x(), q.y(), q.z()));
    }
  EXPECT_EQ(symmetrised(mirror).curves.points, mirror.curves.points);
}

// A ray below the tip of a nose leaves the skin in a nostril: one deep sample made bumps across the whole cheek.
TEST(FaceAcquisition, NostrilsAreNoPartOfTheCurves) {
  SyntheticHead smooth = ellipticHead(), pierced = ellipticHead();
  const auto round = ellipticHead().radius;
  smooth.radius = [round](double azimuth, double y) {
    return round(azimuth, y) + 20.0 * std::exp(-std::pow(azimuth / (9.0 * degree), 2) - std::pow((y + 2.0) / 12.0, 2));
  };
  pierced.radius = [radius = smooth.radius](double azimuth, double y) {
    const bool inNostril = std::abs(std::abs(azimuth) - 4.0 * degree) < 2.1 * degree && y < 1.0 && y > -9.0;
    return radius(azimuth, y) - (inNostril ? 25.0 : 0.0);
  };
  FaceCurves expected, face;
  ASSERT_EQ(acquireFace(smooth.mesh(), smooth.landmarks(), 40, expected), "");
  ASSERT_EQ(acquireFace(pierced.mesh(), smooth.landmarks(), 40, face), "");
  const HeadAxis axis = headAxis(smooth.landmarks());
  double deepest = 0.0;
  for (int c = 0; c < face.curves.count; ++c)
    for (int j = 0; j < 40; ++j) {
      const double narrower = axis.radius(expected.curves.curve(c).row(j)) - axis.radius(face.curves.curve(c).row(j));
      deepest = std::max(deepest, narrower);
      EXPECT_GT(narrower, -0.5) << FaceLayout::curveName(c) << " point " << j;
    }
  EXPECT_LT(deepest, 9.0) << "as far out as the wing, not 25 mm deeper";
}
