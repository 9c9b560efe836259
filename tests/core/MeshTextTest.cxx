#include <gtest/gtest.h>

#include "MeshText.h"

using namespace mien;

namespace {

const std::string plyStart = "ply\nformat ascii 1.0\n";
const std::string plyVertices = "element vertex 5\nproperty float x\nproperty float y\nproperty float z\n";
const std::string plyFaces = "property list uchar int vertex_indices\n";
const std::string places = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n";

MeshText meshOf(const std::string& text, const std::string& ending) {
  MeshText read;
  const auto fault = readMeshText(text, ending, read);
  EXPECT_FALSE(fault.has_value()) << fault->line << ": " << fault->message;
  return read;
}

void expectCounts(const MeshText& read, int triangles, int quads, int larger) {
  EXPECT_EQ(read.polygons.triangles, triangles);
  EXPECT_EQ(read.polygons.quads, quads);
  EXPECT_EQ(read.polygons.larger, larger);
}

void expectFault(const std::string& text, const std::string& ending, std::int64_t line, const std::string& words) {
  MeshText read;
  read.polygons.quads = 7;
  const auto fault = readMeshText(text, ending, read);
  ASSERT_TRUE(fault.has_value()) << text;
  EXPECT_EQ(fault->line, line) << fault->message;
  EXPECT_NE(fault->message.find(words), std::string::npos) << fault->message;
  EXPECT_EQ(read.polygons.quads, 7) << "what was there stays";
}

Eigen::Vector3d normalOf(const TriangleMesh& mesh, int triangle) {
  const auto corner = [&](int i) -> Eigen::Vector3d { return mesh.vertices.row(mesh.triangles(triangle, i)); };
  return (corner(1) - corner(0)).cross(corner(2) - corner(0));
}

}  // namespace

TEST(MeshText, CountsThePolygonsOfTheFile) {
  const std::string obj = "v 0 0 0\r\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\n";
  const MeshText read = meshOf(obj + "f 1 2 3 \r\nf 1/2 2/3/4 3//1 4 # a quad\nf 1 2 3 4 5\nf 1 2 3\nf 1 2\n", ".obj");
  expectCounts(read, 2, 1, 1);
  EXPECT_EQ(read.mesh.triangles.rows(), 1 + 2 + 3 + 1);
  expectCounts(meshOf("OFF\n5 2 0\n" + places + "3 0 1 2\n4 0 1 2 3 255 0 0\n", ".off"), 1, 1, 0);
  expectCounts(meshOf(plyStart + plyVertices + "element face 2\n" + plyFaces + "end_header\n" + places +
                          "4 0 1 2 3\n5 0 1 2 3 4\n",
                      ".ply"),
               0, 1, 1);
}

TEST(MeshText, StripsKeepTheirWindingAndBeginAnew) {
  const MeshText read = meshOf(
      plyStart + plyVertices + "element tristrips 1\n" + plyFaces + "end_header\n" + places + "4 0 1 3 2\n", ".ply");
  ASSERT_EQ(read.mesh.triangles.rows(), 2);
  EXPECT_EQ(normalOf(read.mesh, 0), Eigen::Vector3d(0.0, 0.0, 1.0));
  EXPECT_EQ(normalOf(read.mesh, 1), Eigen::Vector3d(0.0, 0.0, 1.0));
  const std::string two = "element tristrips 1\nproperty list int int vertex_indices\nend_header\n";
  EXPECT_EQ(meshOf(plyStart + plyVertices + two + places + "8 0 1 3 -1 1 2 3 -1\n", ".ply").mesh.triangles.rows(), 2);
}

TEST(MeshText, CornersTwiceMakeNoTriangleAndPlacesOfStlAreOneVertex) {
  EXPECT_EQ(meshOf("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3 3\n", ".obj").mesh.triangles.rows(), 1);
  const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex ";
  const MeshText stl = meshOf(
      "Solid\n" + facet + "1 1 0\nendloop\nendfacet\n" + facet + "1 -1 -0\nendloop\nendfacet\n" + "endsolid\n", ".stl");
  EXPECT_EQ(stl.mesh.vertices.rows(), 4);
  EXPECT_EQ(stl.mesh.triangles.rows(), 2);
}

TEST(MeshText, FaultsNameLineAndCause) {
  expectFault("# c\n# d\n", ".off", 3, "is cut off, the file ends");
  expectFault("4OFF\n3 1 0\n", ".off", 1, "begins with '4OFF' where OFF, COFF, NOFF or STOFF belongs");
  expectFault("OFF\n# c\nthree 1 0\n", ".off", 3, "the header has 'three' where a number belongs");
  expectFault("OFF\n3 1 0\n0 0 0\n1 0 0\n", ".off", 5, "vertex 3 of 3 is cut off, the file ends");
  expectFault(plyStart + "element vertex 1\nproperty float x\nproperty half y\n", ".ply", 5, "unknown type 'half'");
  expectFault(plyStart + "element vertex 1\nproperty float x\nproperty float y\nend_header\n", ".ply", 3,
              "no property z");
  expectFault(plyStart + plyVertices + "element face 1\nproperty int a\nend_header\n" + places + "1\n", ".ply", 7,
              "gives the faces no list vertex_indices");
  expectFault("v 0 0 0\nf 1 x 1\n", ".obj", 2, "'x' where the number of a vertex belongs");
  expectFault(std::string(80, ' ') + std::string("\1\0\0\0abc", 7), ".stl", 0, "triangle 1 of 1 is not there");
}
