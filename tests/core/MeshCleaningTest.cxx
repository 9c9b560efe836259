#include <gtest/gtest.h>

#include "LengthUnit.h"
#include "MeshCleaning.h"
#include "SyntheticHead.h"

using namespace mien;

namespace {

/// As an STL file has it: three vertices of its own for every triangle.
TriangleMesh soup(const TriangleMesh& mesh) {
  TriangleMesh result;
  result.vertices.resize(3 * mesh.triangles.rows(), 3);
  result.triangles.resize(mesh.triangles.rows(), 3);
  for (int t = 0; t < mesh.triangles.rows(); ++t)
    for (int i = 0; i < 3; ++i) {
      result.vertices.row(3 * t + i) = mesh.vertices.row(mesh.triangles(t, i));
      result.triangles(t, i) = 3 * t + i;
    }
  return result;
}

}  // namespace

TEST(MeshCleaning, ASoundMeshStaysAsItIs) {
  const TriangleMesh mesh = ellipticHead().mesh();
  const CleanMesh clean = cleaned(mesh);
  EXPECT_EQ(clean.mesh.vertices, mesh.vertices);
  EXPECT_EQ(clean.mesh.triangles, mesh.triangles);
  EXPECT_EQ(clean.mergedVertices + clean.degenerateTriangles, 0);
}

/// Of a cube of 2 mm, wherever it lies and however it is wound; a missing side takes its share, a sixth.
TEST(MeshCleaning, VolumeIsSigned) {
  TriangleMesh cube;
  cube.vertices.resize(8, 3);
  for (int i = 0; i < 8; ++i) cube.vertices.row(i) << 9 + 2 * (i & 1), (i & 2) - 4, (i >> 1) & 2;
  cube.triangles.resize(12, 3);
  cube.triangles << 0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5,
      3, 7, 5;
  EXPECT_NEAR(signedVolume(cube), 8.0, 1e-12);
  TriangleMesh open = cube;
  open.triangles.conservativeResize(10, 3);
  EXPECT_NEAR(signedVolume(open), 8.0 * 5 / 6, 1e-12);
  cube.triangles.col(0).swap(cube.triangles.col(1));
  EXPECT_NEAR(signedVolume(cube), -8.0, 1e-12);
}

TEST(MeshCleaning, SoupBecomesOnePart) {
  const TriangleMesh mesh = ellipticHead().mesh();
  EXPECT_EQ(partsOf(soup(mesh)).count(), mesh.triangles.rows());
  const CleanMesh clean = cleaned(soup(mesh));
  EXPECT_EQ(clean.mesh.vertices.rows(), mesh.vertices.rows());
  EXPECT_EQ(partsOf(clean.mesh).count(), 1);
  EXPECT_EQ(boundaryLoops(clean.mesh), 2) << "the tube is open above and below";
}

TEST(MeshCleaning, DropsTrianglesWithoutAreaAndTwins) {
  TriangleMesh mesh = ellipticHead().mesh();
  const auto n = mesh.triangles.rows();
  mesh.triangles.conservativeResize(n + 3, 3);
  mesh.triangles.row(n) << 5, 5, 6;
  mesh.triangles.row(n + 1) << mesh.triangles(7, 2), mesh.triangles(7, 1), mesh.triangles(7, 0);
  mesh.triangles.row(n + 2) << 1, 1, 1;
  const CleanMesh clean = cleaned(mesh);
  EXPECT_EQ(clean.degenerateTriangles, 3);
  EXPECT_EQ(clean.mesh.triangles.rows(), n);
}

TEST(MeshCleaning, PartsAreSortedByArea) {
  const TriangleMesh small = ellipticHead().mesh(-10, 10), large = ellipticHead().mesh();
  TriangleMesh both;
  const int first = static_cast<int>(small.vertices.rows());
  both.vertices.resize(first + large.vertices.rows(), 3);
  both.vertices << small.vertices, large.vertices.array() + 500.0;
  both.triangles.resize(small.triangles.rows() + large.triangles.rows(), 3);
  both.triangles << small.triangles, large.triangles.array() + first;
  const MeshParts parts = partsOf(both);
  ASSERT_EQ(parts.count(), 2);
  EXPECT_GT(parts.area[0], parts.area[1]);
  EXPECT_EQ(parts.ofTriangle.front(), 1);
  EXPECT_GT(parts.middle[0].x(), 400.0);
  EXPECT_EQ(withParts(both, parts, {true, false}).triangles.rows(), large.triangles.rows());
  EXPECT_EQ(boundaryLoops(both), 4);
}

TEST(MeshCleaning, NormalsPointOutwardsWhateverTheWinding) {
  TriangleMesh mesh = ellipticHead().mesh();
  const TriangleMesh::Vertices normals = outwardNormals(mesh);
  for (int i = 0; i < normals.rows(); i += 17) {
    const Eigen::RowVector3d out = mesh.vertices.row(i) - Eigen::RowVector3d(0.0, mesh.vertices(i, 1), 25.0);
    EXPECT_GT(normals.row(i).dot(out.normalized()), 0.8);
  }
  mesh.triangles.col(1).swap(mesh.triangles.col(2));
  EXPECT_LT((outwardNormals(mesh) - normals).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(LengthUnit, NoTwoUnitsFitAnEyeDistance) {
  for (double length = 1e-4; length < 1e4; length *= 1.01)
    EXPECT_LE(unitsThatFit(length, smallestEyeDistance, largestEyeDistance).size(), 1u) << length;
  EXPECT_EQ(unitsThatFit(0.09, smallestEyeDistance, largestEyeDistance).front().name, "m");
  EXPECT_EQ(lengthUnit("in"), lengthUnit("inch"));
  EXPECT_EQ(lengthUnit("mile"), nullptr);
}
