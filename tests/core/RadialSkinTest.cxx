#include <gtest/gtest.h>

#include "RadialSkin.h"
#include "SyntheticHead.h"

using namespace mien;

TEST(RadialSkin, FindsTheSurfaceAtVerticesExactly) {
  const SyntheticHead head = ellipticHead();
  const TriangleMesh mesh = head.mesh();
  const RadialSkin skin(mesh, head.axis);
  for (int azimuth = -180; azimuth < 180; azimuth += 14)
    for (int y = -90; y < 120; y += 26)
      EXPECT_NEAR(skin.radius(azimuth * M_PI / 180.0, y), head.radius(azimuth * M_PI / 180.0, y), 1e-9);
}

TEST(RadialSkin, StaysWithinTheSagOfTheTrianglesBetweenVertices) {
  const SyntheticHead head = ellipticHead();
  const TriangleMesh mesh = head.mesh();
  const RadialSkin skin(mesh, head.axis);
  for (double azimuth = -3.1; azimuth < 3.1; azimuth += 0.0373)
    EXPECT_NEAR(skin.radius(azimuth, 0.37), head.radius(azimuth, 0.37), 0.03);
}

TEST(RadialSkin, TakesTheOutermostOfSeveralSurfaces) {
  SyntheticHead inner = ellipticHead();
  TriangleMesh mesh = inner.mesh();
  const int vertices = static_cast<int>(mesh.vertices.rows()), triangles = static_cast<int>(mesh.triangles.rows());
  inner.radius = [](double, double) { return 40.0; };
  const TriangleMesh core = inner.mesh();
  mesh.vertices.conservativeResize(2 * vertices, 3);
  mesh.triangles.conservativeResize(2 * triangles, 3);
  mesh.vertices.bottomRows(vertices) = core.vertices;
  mesh.triangles.bottomRows(triangles) = core.triangles.array() + vertices;
  const RadialSkin skin(mesh, inner.axis);
  EXPECT_NEAR(skin.radius(0.0, 0.0), 90.0, 1e-9);
}

TEST(RadialSkin, SaysWhereThereIsNoSkin) {
  const SyntheticHead head = ellipticHead();
  const TriangleMesh mesh = head.mesh();
  EXPECT_TRUE(std::isnan(RadialSkin(mesh, head.axis).radius(0.5, 500.0)));
}

TEST(RadialSkin, BridgesHolesOnAFlatBrow) {
  const SyntheticHead head = ellipticHead();
  const TriangleMesh whole = head.mesh();
  for (const double radius : {6.0, 9.0, 12.0, 15.0}) {
    const Eigen::Vector3d middle = head.axis.point(0.1, 60.0, head.radius(0.1, 60.0));
    std::vector<Eigen::Vector3i> kept;
    for (int t = 0; t < whole.triangles.rows(); ++t) {
      const Eigen::RowVector3d centre =
          (whole.vertices.row(whole.triangles(t, 0)) + whole.vertices.row(whole.triangles(t, 1)) +
           whole.vertices.row(whole.triangles(t, 2))) /
          3.0;
      if ((centre.transpose() - middle).norm() > radius) kept.emplace_back(whole.triangles.row(t));
    }
    TriangleMesh mesh = whole;
    mesh.triangles.resize(static_cast<int>(kept.size()), 3);
    for (size_t t = 0; t < kept.size(); ++t) mesh.triangles.row(static_cast<int>(t)) = kept[t];
    const RadialSkin skin(mesh, head.axis);
    int missing = 0;
    for (double azimuth = -0.1; azimuth < 0.3; azimuth += 0.013)
      for (double y = 42.0; y < 78.0; y += 1.3) {
        missing += std::isnan(skin.radius(azimuth, y));
        EXPECT_NEAR(skin.filledRadius(azimuth, y), head.radius(azimuth, y), 0.1)
            << "hole of " << radius << " mm, azimuth " << azimuth << ", height " << y;
      }
    EXPECT_GT(missing, 10);
  }
}

TEST(RadialSkin, DescribesUnusableMeshes) {
  TriangleMesh mesh = ellipticHead().mesh();
  EXPECT_EQ(describeFault(mesh), "");
  mesh.triangles(5, 1) = static_cast<int>(mesh.vertices.rows());
  EXPECT_NE(describeFault(mesh).find("does not have"), std::string::npos);
  mesh.vertices(3, 2) = NAN;
  EXPECT_NE(describeFault(mesh).find("finite"), std::string::npos);
  EXPECT_NE(describeFault(TriangleMesh()).find("no triangles"), std::string::npos);
}
