#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "PipelineErrors.h"
#include "TemporaryFolder.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkScanReader.h"

namespace {

std::string writeFile(const std::string& name, const std::string& text) {
  static const TemporaryFolder folder;
  const std::string path = folder.file(name);
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

std::string errorOf(const std::string& file) {
  vtkNew<vtkScanReader> reader;
  mien::PipelineErrors errors;
  errors.observe(reader);
  reader->SetFileName(file.c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
  return errors.first();
}

void expectTwoTriangles(const std::string& file) {
  vtkNew<vtkScanReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPolyData* mesh = reader->GetOutput();
  ASSERT_EQ(mesh->GetNumberOfPoints(), 4) << file;
  EXPECT_EQ(mesh->GetNumberOfPolys(), 2) << file;
  double bounds[6];
  mesh->GetBounds(bounds);
  EXPECT_DOUBLE_EQ(bounds[1], 2.0);
  EXPECT_DOUBLE_EQ(bounds[3], 3.0);
}

}  // namespace

TEST(ScanReader, SplitsPolygonsOfEveryFormat) {
  expectTwoTriangles(writeFile("quad.obj", "v 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 0\nf 1 2 3 4\n"));
  expectTwoTriangles(writeFile("quad.off", "OFF\n4 1 0\n0 0 0\n2 0 0\n2 3 0\n0 3 0\n4 0 1 2 3\n"));
  expectTwoTriangles(
      writeFile("quad.ply",
                "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
                "float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n2 0 "
                "0\n2 3 0\n0 3 0\n4 0 1 2 3\n"));
  expectTwoTriangles(
      writeFile("quad.stl",
                "solid q\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 2 3 "
                "0\nendloop\nendfacet\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 3 0\nvertex 0 3 "
                "0\nendloop\nendfacet\nendsolid q\n"));
}

TEST(ScanReader, ReadsBinarySTL) {
  std::string bytes = std::string(80, ' ') + std::string("\2\0\0\0", 4);
  for (const std::vector<float>& triangle :
       {std::vector<float>{0, 0, 1, 0, 0, 0, 2, 0, 0, 2, 3, 0}, std::vector<float>{0, 0, 1, 0, 0, 0, 2, 3, 0, 0, 3, 0}})
    bytes += std::string(reinterpret_cast<const char*>(triangle.data()), 48) + std::string(2, '\0');
  expectTwoTriangles(writeFile("binary.stl", bytes));
  expectTwoTriangles(writeFile("longer.stl", bytes + "\n"));
  bytes.replace(0, 5, "solid");
  expectTwoTriangles(writeFile("solid.stl", bytes));
}

TEST(ScanReader, ReadsWhatOtherProgramsWrite) {
  const std::string square = "0 0 0\n2 0 0\n2 3 0\n0 3 0\n";
  for (const char* header :
       {"OFF\n# a scan\n4 1 0\n", "# a scan\n\nOFF\n4 1 0 # counts\n", "OFF 4 1 0\n", "off\n4 1\n"})
    expectTwoTriangles(writeFile("header.off", header + square + "4 0 1 2 3\n"));
  const std::string vertices = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string list = "property list uchar int vertex_indices\n", start = "ply\nformat ascii 1.0\n";
  expectTwoTriangles(writeFile("flags.ply", start + vertices + "element face 1\nproperty uchar flags\n" + list +
                                                "end_header\n" + square + "7 4 0 1 2 3\n"));
  expectTwoTriangles(
      writeFile("first.ply", start + "element face 1\n" + list + vertices + "end_header\n4 0 1 2 3\n" + square));
  expectTwoTriangles(writeFile("strips.ply", start + vertices + "element tristrips 1\nproperty list int int " +
                                                 "vertex_indices\nend_header\n" + square + "8 0 1 3 2 -1 2 3 -1\n"));
  expectTwoTriangles(writeFile("lines.obj", "v 0 0 0\nv 2 0 \\\n0\nv 2 3 0\nv 0 3 0\nf 1 2\\\n 3 \\\n4\n"));
  expectTwoTriangles(writeFile(
      "capitals.stl",
      "SOLID Q\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 2 0 0\nVERTEX 2 3 0\nENDLOOP\nENDFACET\nFACET "
      "NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 2 3 0\nVERTEX 0 3 0\nENDLOOP\nENDFACET\nENDSOLID\n"));
}

TEST(ScanReader, NamesTheFileAtFault) {
  EXPECT_NE(errorOf("/no/such/scan.ply").find("/no/such/scan.ply: there is no such file"), std::string::npos);
  EXPECT_NE(errorOf(writeFile("scan.xyz", "1 2 3\n")).find("ending"), std::string::npos);
  EXPECT_NE(errorOf(writeFile("text.ply", "this is no mesh\n")).find("text.ply: "), std::string::npos);
  EXPECT_NE(errorOf(writeFile("empty.obj", "")).find("empty.obj: "), std::string::npos);
}

TEST(ScanReader, RefusesAHeaderThatPromisesMoreThanTheFileHolds) {
  const std::string vertices = "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\n";
  const std::string faces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const std::string places = "property float x\nproperty float y\nproperty float z\n";
  for (const auto& [file, what] : {
           std::pair{writeFile("huge.ply", vertices + places + faces), ":3: the header promises more"},
           {writeFile("huge.off", "OFF\n2000000000 2000000000 0\n0 0 0\n"), ":2: the header promises more"},
           {writeFile("binary.off", "OFF BINARY\n\xff\xff\xff\x7f\xff\xff\xff\x7f"), ":1: the header promises more"},
           {writeFile("huge.stl", std::string(80, 'x') + "\xff\xff\xff\xff" + std::string(50, '\1')),
            ": triangle 2 of 4294967295 is not there"},
       })
    EXPECT_EQ(errorOf(file).rfind(file + what, 0), 0u) << errorOf(file);
}

TEST(ScanReader, NegativeCountsAreRefused) {
  const std::string rest = "property float x\nproperty float y\nproperty float z\nelement face ";
  const std::string list = "\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n";
  const std::string start = "ply\nformat ascii 1.0\nelement vertex ";
  for (const auto& [text, what] : {std::pair{start + "-4\n" + rest + "1" + list, ":3: the header has '-4' where"},
                                   {start + "1\n" + rest + "-1" + list, ":7: the header has '-1' where"}})
    EXPECT_NE(errorOf(writeFile("negative.ply", text)).find(what), std::string::npos);
  for (const char* const counts : {"-4 1 0", "4 -1 0"})
    EXPECT_NE(errorOf(writeFile("negative.off", std::string("OFF\n") + counts + "\n0 0 0\n")).find("fewer vertices"),
              std::string::npos)
        << counts;
}

TEST(ScanReader, RefusesVerticesThatAreNoNumbersWithTheirLine) {
  for (const auto& [vertex, what] : {std::pair{"v nan 0 0", "'nan' where a finite number belongs"},
                                     {"v 0 inf 0", "'inf' where a finite number belongs"},
                                     {"v 1 2 three", "'three' where a finite number belongs"},
                                     {"v 0 0", "2 numbers, not three"},
                                     {"v", "0 numbers, not three"}}) {
    const std::string file =
        writeFile("hole.obj", std::string("v 0 0 0\nv 2 0 0\n") + vertex + "\nv 2 3 0\nv 0 3 0\nf 1 2 4 5\n");
    EXPECT_EQ(errorOf(file).rfind(file + ":3: a vertex has " + what, 0), 0u) << errorOf(file);
  }
  for (const auto& [word, what] : {std::pair{"nan", "'nan' where a finite number belongs"},
                                   {"1e999", "'1e999' where a finite number belongs"},
                                   {"ten", "'ten' where a number belongs"},
                                   {"1,5", "'1,5' where a number belongs"}}) {
    const std::string off = writeFile("hole.off", std::string("OFF\n3 1 0\n0 0 0\n2 ") + word + " 0\n2 3 0\n3 0 1 2\n");
    EXPECT_EQ(errorOf(off).rfind(off + ":4: vertex 2 of 3 has " + what, 0), 0u) << errorOf(off);
  }
}

TEST(ScanReader, RefusesFacesWithCornersThatAreNoVertices) {
  const std::string places = "v 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 0\n";
  const std::string obj = errorOf(writeFile("far.obj", places + "f 1 2 3 4\nf 1 2 5\nf 0 1 2\n"));
  EXPECT_NE(obj.find(":6: a face has the corner 5, but there are 4 vertices (2 faces are like that)"),
            std::string::npos)
      << obj;
  const std::string off = errorOf(writeFile("far.off", "OFF\n3 2 0\n0 0 0\n2 0 0\n2 3 0\n3 0 1 2\n3 0 1 7\n"));
  EXPECT_NE(off.find(":7: a face has the corner 7, but there are 3 vertices;"), std::string::npos) << off;
  const std::string header =
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 2\nproperty list "
      "uchar int vertex_indices\nend_header\n";
  const std::string text =
      errorOf(writeFile("far.ply", "ply\nformat ascii 1.0\n" + header + "0 0 0\n2 0 0\n2 3 0\n3 0 1 2\n3 0 -1 2\n"));
  EXPECT_NE(text.find(":14: a face has the corner -1"), std::string::npos) << text;
  std::string bytes = "ply\nformat binary_little_endian 1.0\n" + header + std::string(36, '\0');
  for (const char corner : {'\2', '\3'}) bytes += std::string("\3\0\0\0\0\1\0\0\0", 9) + corner + std::string(3, '\0');
  const std::string binary = errorOf(writeFile("far_binary.ply", bytes));
  EXPECT_NE(binary.find("face 2: a face has the corner 3"), std::string::npos) << binary;
}

TEST(ScanReader, CornersCountedFromTheEndAndLaterVerticesAreNoFault) {
  expectTwoTriangles(writeFile("back.obj", "v 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 0\nvt 0 0\nf -4/1 -3/1 -2/1 -1/1\n"));
}

TEST(ScanReader, TellsFoldersAndFilesOfAnotherFormat) {
  const TemporaryFolder folder;
  const std::string named = folder.file("head.ply");
  std::filesystem::create_directory(named);
  EXPECT_NE(errorOf(named).find("it is a folder"), std::string::npos);
  EXPECT_NE(errorOf(writeFile("words.ply", "a letter\n")).find("this is no PLY file"), std::string::npos);
  EXPECT_NE(errorOf(writeFile("words.stl", "a letter\n")).find("this is no STL file"), std::string::npos);
}
