#include <gtest/gtest.h>

#include <cstring>

#include "MeshText.h"
#include "PolygonFile.h"

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

void expectSize(const std::string& text, const std::string& ending, int vertices, int triangles) {
  MeshText read;
  const auto fault = readMeshText(text, ending, read);
  EXPECT_FALSE(fault.has_value()) << text << fault->line << ": " << fault->message;
  EXPECT_EQ(read.mesh.vertices.rows(), vertices) << text;
  EXPECT_EQ(read.mesh.triangles.rows(), triangles) << text;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

/// "OFF BINARY" of two triangles over four vertices, with so many words more behind each vertex and face.
std::string offBytes(bool isBigEndian, int vertexWords, const std::vector<std::uint32_t>& faceWords,
                     const std::string& magic = "OFF BINARY\n") {
  std::string bytes = magic;
  const auto add = [&](std::uint32_t word) {
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(word >> 8 * (isBigEndian ? 3 - i : i));
  };
  const auto addReal = [&](float real) {
    std::uint32_t word;
    std::memcpy(&word, &real, 4);
    add(word);
  };
  for (const std::uint32_t count : {4, 2, 0}) add(count);
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 3 + vertexWords; ++k) addReal(k == 0 ? static_cast<float>(i % 2) : k == 1 ? i / 2 : 0.5f);
  for (const std::vector<std::uint32_t>& corners : {std::vector<std::uint32_t>{3, 0, 1, 2}, {3, 1, 3, 2}}) {
    for (const std::uint32_t corner : corners) add(corner);
    for (const std::uint32_t word : faceWords) add(word);
  }
  return bytes;
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

TEST(MeshText, OnlyVerticesAndFacesOfObjGoOn) {
  const std::string mesh = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";
  for (const char* const keyword : {"#", "# of", "g", "o", "usemtl", "mtllib", "s", "vp"}) {
    expectSize(std::string(keyword) + " C:\\scans\\\n" + mesh, ".obj", 4, 2);
    expectSize(replaced(mesh, "f 1 2", std::string(keyword) + " C:\\\nf 1 2"), ".obj", 4, 2);
  }
  expectSize("v 0 0 \\\n0\nv 1 0 0\nvn 1 2 \\\n3\nv 1 1 0\nf 1 \\\n2 \\\n3\n", ".obj", 3, 1);
  expectSize("v 0 0 0#a\nv 1 0 0 # b \\\nv 1 1 0\nf 1 2 3#q\n", ".obj", 3, 1);
  expectFault("v 0 0 0\nv 1 \\\n0\n", ".obj", 2, "2 numbers, not three");
}

TEST(MeshText, BinaryOffOfEitherByteOrderWithAndWithoutColours) {
  for (const bool isBigEndian : {false, true}) {
    for (const std::vector<std::uint32_t>& colour :
         {std::vector<std::uint32_t>{}, {0}, {1, 7}, {3, 7, 8, 9}, {7, 8, 9}})
      expectSize(offBytes(isBigEndian, 0, colour), ".off", 4, 2);
    expectSize(offBytes(isBigEndian, 3, {}, "NOFF BINARY\n"), ".off", 4, 2);
    expectSize(offBytes(isBigEndian, 9, {0}, "STCNOFF BINARY\n"), ".off", 4, 2);
    expectSize(offBytes(isBigEndian, 3, {}, "COFF BINARY\n"), ".off", 4, 2);
    const MeshText read = meshOf(offBytes(isBigEndian, 0, {0}), ".off");
    EXPECT_EQ(normalOf(read.mesh, 0), Eigen::Vector3d(0.0, 0.0, 1.0));
    EXPECT_EQ(normalOf(read.mesh, 1), Eigen::Vector3d(0.0, 0.0, 1.0));
    const std::string sound = offBytes(isBigEndian, 0, {});
    for (const std::string& bytes : {sound + std::string(4, '\0'), sound + "x", sound.substr(0, sound.size() - 4)})
      expectFault(bytes, ".off", 1, "the header promises more vertices or faces, or fewer, than lie between");
  }
}

TEST(MeshText, OffWithCommentsColoursAndWithoutItsFirstWord) {
  const std::string faces = "3 0 1 2\n3 0 2 3 255 0 0\n", square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  const std::string plain = "OFF\n4 2 0\n" + square + faces;
  for (const std::string& text :
       {plain, "4 2 0\n" + square + faces, "4 2\n" + square + faces,
        "OFF # of 2024-03-01\n4 2 0 # k\n" + square + faces, "  # take 99999\n" + plain, "\xEF\xBB\xBF" + plain,
        "\n \n" + plain, replaced(plain, "\n", "\r"), replaced(plain, "\n", "\r\n"),
        "OFF\n4 2 0\n" + replaced(square, "\n", " 255 0 0\n") + faces,
        "OFF\n4 2 0\n" + replaced(square, "\n", " ") + "\n" + faces,
        "OFF 4 2 0\n" + replaced(square, " ", "\n") + faces})
    expectSize(text, ".off", 4, 2);
  EXPECT_EQ(meshOf("4 2 0\r" + replaced(square, "\n", " .1 .2 .3\r") + faces, ".off").mesh.vertices.row(2),
            Eigen::RowVector3d(1.0, 1.0, 0.0));
  expectFault(replaced(plain, "3 0 2 3", "3 0 2 x"), ".off", 8, "'x' where a number belongs");
  expectFault(replaced(replaced(plain, "3 0 2 3", "3 0 2 x"), "\n", "\r"), ".off", 8, "'x' where a number belongs");
  expectFault("OFF\n4.5 2 0\n", ".off", 2, "has a count that is none");
}

TEST(MeshText, PlyOfAnyLineEndsTypesAndLines) {
  const std::string header = plyStart + plyVertices + "element face 2\n" + plyFaces + "end_header\n";
  const std::string plain = header + places + "3 0 1 2\n3 0 2 3\n";
  for (const std::string& text :
       {plain, replaced(plain, "\n", "\r"), replaced(plain, "\n", "\r\n"), "\xEF\xBB\xBF" + plain, "\n " + plain,
        header + replaced(places + "3 0 1 2\n3 0 2 3", "\n", " "), replaced(plain, "uchar int", "uint64 int64"),
        plyStart + plyVertices + "property string name\nelement face 2\n" + plyFaces + "end_header\n" +
            replaced(places, "\n", " a\n") + "3 0 1 2\n3 0 2 3\n"})
    expectSize(text, ".ply", 5, 2);
  expectFault(replaced(plain, "property float z\n", "property\n"), ".ply", 6, "has a property that is incomplete");
  expectFault(replaced(plain, "element face 2", "element face"), ".ply", 7, "has an element that is incomplete");
  expectFault("\n" + replaced(plain, "0 2 3", "0 2 y"), ".ply", 17, "'y' where a number belongs");
  expectFault(" play\n", ".ply", 0, "this is no PLY file");
}

TEST(MeshText, ListsMayBeAsLongAsTheFile) {
  constexpr int corners = 1200000;
  std::string strip;
  for (int i = 0; i < corners; ++i) strip += " " + std::to_string(i % 5);
  const std::string header = plyStart + plyVertices + "element tristrips 1\nproperty list int int vertex_indices\n";
  expectSize(header + "end_header\n" + places + std::to_string(corners) + strip + "\n", ".ply", 5, corners - 2);
  expectFault(header + "end_header\n" + places + "4 0 1 2", ".ply", 15,
              "list of 4 numbers, for which the file has no room");
  const std::string binary = replaced(plyStart + plyVertices, "ascii", "binary_little_endian") + "element face 1\n";
  const std::string image = "property list uint uchar image\n", bytes = std::string(60, '\0');
  const std::string face = std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13) + std::string("\0\0\x20\0", 4);
  expectSize(binary + plyFaces + image + "end_header\n" + bytes + face + std::string(1 << 21, '\1'), ".ply", 5, 1);
  expectFault(binary + plyFaces + image + "end_header\n" + bytes + face + std::string((1 << 21) - 1, '\1'), ".ply", 0,
              "face 1 of 1 is a list of 2097152 numbers");
}

TEST(MeshText, FacesOfBinaryFilesCountFromOne) {
  const std::string header = replaced(plyStart + plyVertices, "ascii", "binary_little_endian") + "element face 1\n";
  expectFault(
      header + plyFaces + "end_header\n" + std::string(60, '\0') + std::string("\3\0\0\0\0\1\0\0\0\x9\0\0\0", 13),
      ".ply", 0, "face 1: a face has the corner 9, but there are 5 vertices");
}

TEST(MeshText, NumbersTooSmallToHoldAreZero) {
  EXPECT_EQ(meshOf("OFF\n3 1 0\n0 1e-400 0\n1 -1e-400 0\n1 1 0\n3 0 1 2\n", ".off").mesh.vertices(0, 1), 0.0);
  EXPECT_EQ(meshOf("v 0 1e-400 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n", ".obj").mesh.vertices(0, 1), 0.0);
  expectFault("OFF\n3 1 0\n0 1e400 0\n", ".off", 3, "'1e400' where a finite number belongs");
}

TEST(MeshText, StlTextAsProgramsWriteIt) {
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet\n";
  const std::string plain = "solid x\n" + facet + "endsolid x\n";
  for (const std::string& text :
       {plain, plain + std::string(1, '\0'), plain + std::string(500, '\0'), plain + "# end\n",
        plain + "made by x\nvertex\n", "\n  " + plain, "\xEF\xBB\xBF" + plain, "# made by x\n" + plain,
        replaced(plain, "\n", "\r"), replaced(replaced(plain, "endloop", "end loop"), "endfacet", "end facet"),
        replaced(plain, "endsolid", "END SOLID")})
    expectSize(text, ".stl", 3, 1);
  expectSize(plain + replaced(plain, "0 0 0", "0 1 0"), ".stl", 4, 2);
  expectFault(plain + "solid y\n" + facet, ".stl", 17, "the file ends without endsolid");
  expectFault("a letter without any facet\n", ".stl", 0, "this is no STL file");
  std::string bytes = "solid facet vertex" + std::string(62, ' ') + std::string("\1\0\0\0", 4) + std::string(50, '\0');
  expectSize(bytes, ".stl", 1, 0);
  EXPECT_EQ(meshOf(bytes, ".stl").polygons.triangles, 1) << "bytes, whatever the title";
}

TEST(PolygonFile, TellsTheLineWhereAFaceBegins) {
  const std::string text = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1\n0\n\n# face\n3\n0 1\n2\n";
  PolygonFile file;
  ASSERT_TRUE(file.openOff(text));
  double place[3];
  for (const int line : {3, 4, 5}) {
    ASSERT_TRUE(file.readVertex(place));
    EXPECT_EQ(file.lineOfRow(), line);
  }
  std::vector<std::int64_t> corners;
  ASSERT_TRUE(file.readFace(corners));
  EXPECT_EQ(file.lineOfRow(), 9);
}
