#include <gtest/gtest.h>

#include <numeric>

#include "FaceBand.h"
#include "FaceLayout.h"
#include "SurfaceSamples.h"
#include "SyntheticFace.h"

using namespace mien;

namespace {

TriangleMesh square(double size) {
  TriangleMesh mesh;
  mesh.vertices.resize(4, 3);
  mesh.vertices << 0, 0, 0, size, 0, 0, size, size, 0, 0, size, 0;
  mesh.triangles.resize(2, 3);
  mesh.triangles << 0, 1, 2, 0, 2, 3;
  return mesh;
}

bool all(const Eigen::Vector3d&) {
  return true;
}

}  // namespace

TEST(SurfaceSamples, AreasSumUpAndLinearFunctionsIntegrateExactly) {
  for (const double spacing : {0.3, 1.0, 5.0, 100.0}) {
    const SurfaceSamples samples(square(10.0), spacing, all);
    double area = 0.0, integral = 0.0;
    for (std::size_t i = 0; i < samples.points.size(); ++i) {
      area += samples.areas[i];
      integral += samples.areas[i] * (2.0 * samples.points[i].x() - samples.points[i].y() + 1.0);
    }
    EXPECT_NEAR(area, 100.0, 1e-9) << spacing;
    EXPECT_NEAR(integral, 600.0, 1e-8) << spacing;
  }
}

TEST(SurfaceSamples, FollowTheSpacingAndTheChoice) {
  const SurfaceSamples samples(square(10.0), 1.0, [](const Eigen::Vector3d& p) { return p.x() < 5.0; });
  EXPECT_NEAR(std::accumulate(samples.areas.begin(), samples.areas.end(), 0.0), 50.0, 4.0);
  EXPECT_GT(samples.points.size(), 50u);
  for (const Eigen::Vector3d& point : samples.points) EXPECT_LT(point.x(), 5.0);
}

TEST(FaceBand, HoldsWhatLiesBetweenTheFirstAndTheLastCurve) {
  const FaceCurves face = SyntheticFace::make();
  const FaceBand band(face.curves);
  for (int c = 1; c + 1 < FaceLayout::curveCount; ++c)
    for (int j = 0; j < 40; ++j) EXPECT_TRUE(band.contains(face.curves.curve(c).row(j), 0.0)) << c << " " << j;
  for (int j = 0; j < 40; ++j)
    for (const int c : {0, FaceLayout::curveCount - 1}) {
      const Eigen::Vector3d point = face.curves.curve(c).row(j), out(0.0, c == 0 ? 1.0 : -1.0, 0.0);
      EXPECT_FALSE(band.contains(point + out, 0.0)) << c << " " << j;
      EXPECT_TRUE(band.contains(point + out, -2.0)) << c << " " << j;
      EXPECT_TRUE(band.contains(point - out, 0.5)) << c << " " << j;
      EXPECT_FALSE(band.contains(point - out, 1.5)) << c << " " << j;
    }
}
