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

TEST(RadialSkin, DescribesUnusableMeshes) {
  TriangleMesh mesh = ellipticHead().mesh();
  EXPECT_EQ(describeFault(mesh), "");
  mesh.triangles(5, 1) = static_cast<int>(mesh.vertices.rows());
  EXPECT_NE(describeFault(mesh).find("does not have"), std::string::npos);
  mesh.vertices(3, 2) = NAN;
  EXPECT_NE(describeFault(mesh).find("finite"), std::string::npos);
  EXPECT_NE(describeFault(TriangleMesh()).find("no triangles"), std::string::npos);
}
