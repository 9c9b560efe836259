#include <gtest/gtest.h>

#include <random>

#include "MeshCode.h"
#include "SyntheticHead.h"

using namespace mien;

TEST(MeshCode, PlainSizesAreFloatsAndIndices) {
  TriangleMesh mesh;
  mesh.vertices.resize(580, 3);
  mesh.triangles.resize(1160, 3);
  EXPECT_EQ(plainMeshSize(mesh), 13920u);
  mesh.vertices.resize(65537, 3);
  EXPECT_EQ(plainMeshSize(mesh), 65537u * 12 + 1160u * 12);
}

TEST(MeshCode, RoundingMovesNoCoordinateFurtherThanHalfAStep) {
  const TriangleMesh mesh = ellipticHead().mesh();
  EXPECT_LE((roundedMesh(mesh, 0.3).vertices - mesh.vertices).cwiseAbs().maxCoeff(), 0.15 + 1e-12);
}

TEST(MeshCode, ASmoothMeshPacksIntoASixthOfItsPlainSize) {
  const TriangleMesh mesh = ellipticHead().mesh();
  EXPECT_LT(packedMeshSize(mesh, 0.1), plainMeshSize(mesh) / 6);
  EXPECT_LT(packedMeshSize(mesh, 1.0), packedMeshSize(mesh, 0.1));
}

TEST(MeshCode, NoiseCannotBePackedAway) {
  TriangleMesh mesh = ellipticHead().mesh();
  std::mt19937 random(5);
  std::uniform_real_distribution<double> noise(-12.8, 12.8);
  for (int i = 0; i < mesh.vertices.size(); ++i) mesh.vertices.data()[i] += noise(random);
  // 256 equally likely values of each coordinate: 8 bits that nothing predicts
  EXPECT_GT(packedMeshSize(mesh, 0.1), static_cast<std::size_t>(mesh.vertices.rows()) * 3);
}
