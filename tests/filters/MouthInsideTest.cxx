#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "FaceFiles.h"
#include "FaceLayout.h"
#include "MouthCorners.h"
#include "MouthInside.h"

using namespace mien;

namespace {

constexpr double opening = 20.0;  // mm

/// The generic face with its lower lip drawn down between the corners of the mouth.
FaceCurves openMouth() {
  FaceCurves face = genericFace();
  const MouthCorners corners(face);
  const int count = face.curves.pointsPerCurve;
  for (int i = 0; i < count; ++i) {
    const double v = 2.0 * M_PI * i / count, share = (v - corners.begin) / (corners.end - corners.begin);
    if (corners.contain(v)) face.curves.curve(FaceLayout::lowerLip)(i, 1) -= opening * std::sin(M_PI * share);
  }
  return face;
}

/// Of a triangle in the front view, without a sign.
double frontArea(const MouthInside& inside, const std::array<int, 3>& corners) {
  const Eigen::Vector3d one = inside.points[corners[1]] - inside.points[corners[0]],
                        other = inside.points[corners[2]] - inside.points[corners[0]];
  return 0.5 * std::abs(one.x() * other.y() - one.y() * other.x());
}

}  // namespace

TEST(MouthInside, AClosedMouthHasNone) {
  EXPECT_TRUE(MouthInside(genericFace()).triangles.empty());
}

TEST(MouthInside, LiesBehindTheWholeOpening) {
  const FaceCurves face = openMouth();
  const MouthInside inside(face);
  ASSERT_FALSE(inside.triangles.empty());
  double area = 0.0, seen = 0.0;
  for (const std::array<int, 3>& corners : inside.triangles) area += frontArea(inside, corners);
  const auto upper = face.curves.curve(FaceLayout::upperLip), lower = face.curves.curve(FaceLayout::lowerLip);
  for (int i = 0; i + 1 < face.curves.pointsPerCurve; ++i)
    seen +=
        0.5 * std::abs(upper(i + 1, 0) - upper(i, 0)) * (upper(i, 1) - lower(i, 1) + upper(i + 1, 1) - lower(i + 1, 1));
  EXPECT_GT(seen, 100.0);
  EXPECT_NEAR(area, seen, 0.25 * seen) << "seen from the front it fills the opening, and hardly more";
  for (size_t p = 1; p < inside.points.size(); ++p) {
    const double before = std::min((upper.rowwise() - inside.points[p].transpose()).rowwise().norm().minCoeff(),
                                   (lower.rowwise() - inside.points[p].transpose()).rowwise().norm().minCoeff());
    EXPECT_LE(before, MouthInside::retreat + MouthInside::overlap) << p;
  }
  EXPECT_LT(inside.points[0].z(), upper.col(2).maxCoeff() - 0.5 * MouthInside::depth);
}

TEST(MouthInside, TurnsWithTheHead) {
  FaceCurves face = openMouth();
  const MouthInside before(face);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(0.6, 0.0, 0.8)).toRotationMatrix();
  face.curves.points = (face.curves.points * turn.transpose()).eval();
  const MouthInside after(face);
  ASSERT_EQ(before.points.size(), after.points.size());
  for (size_t p = 0; p < before.points.size(); ++p) EXPECT_LT((turn * before.points[p] - after.points[p]).norm(), 1e-9);
}
