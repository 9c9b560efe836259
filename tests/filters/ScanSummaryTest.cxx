#include <gtest/gtest.h>

#include <fstream>

#include "DenseFace.h"
#include "ScanSummary.h"
#include "SyntheticHead.h"
#include "TemporaryFolder.h"

namespace {

const TemporaryFolder& folder() {
  static const TemporaryFolder here;
  return here;
}

std::string writeObj(const std::string& name, const mien::TriangleMesh& mesh, double scale = 1.0) {
  std::ofstream file(folder().file(name));
  file.precision(12);
  for (int i = 0; i < mesh.vertices.rows(); ++i) file << "v " << scale * mesh.vertices.row(i) << "\n";
  for (int i = 0; i < mesh.triangles.rows(); ++i) file << "f " << mesh.triangles.row(i).array() + 1 << "\n";
  return folder().file(name);
}

mien::ScanSummary summaryOf(const std::string& file) {
  mien::ScanSummary summary;
  EXPECT_EQ(mien::summarizeScan(file, summary), "");
  return summary;
}

}  // namespace

TEST(ScanSummary, TellsPointsPartsLoopsAndTheBox) {
  const mien::TriangleMesh head = ellipticHead().mesh(), stray = ellipticHead().mesh(-10, 10);
  mien::TriangleMesh both;
  const int first = static_cast<int>(head.vertices.rows());
  both.vertices.resize(first + stray.vertices.rows(), 3);
  both.vertices << head.vertices, stray.vertices.array() + 300.0;
  both.triangles.resize(head.triangles.rows() + stray.triangles.rows() + 1, 3);
  both.triangles << head.triangles, stray.triangles.array() + first, Eigen::RowVector3i(5, 5, 6);
  const mien::ScanSummary summary = summaryOf(writeObj("both.obj", both));
  EXPECT_EQ(summary.points, both.vertices.rows());
  EXPECT_EQ(summary.polygons.triangles, both.triangles.rows());
  EXPECT_EQ(summary.polygons.quads, 0);
  EXPECT_EQ(summary.components, 2);
  EXPECT_NEAR(summary.largestShare, 0.92, 0.02);
  EXPECT_EQ(summary.boundaryLoops, 4) << "two tubes, open above and below";
  EXPECT_EQ(summary.loopsOfLargest, 2);
  EXPECT_NEAR(summary.low[1], -100.0, 1e-6);
  EXPECT_NEAR(summary.high[1], 310.0, 1e-6);
}

TEST(ScanSummary, GuessesTheUnitAsAcquisitionDoes) {
  const DenseFace face(101, 90);
  for (const auto& [unit, scale] :
       {std::pair<const char*, double>{"mm", 1.0}, {"cm", 0.1}, {"m", 0.001}, {"inch", 1.0 / 25.4}}) {
    const mien::ScanSummary summary = summaryOf(writeObj("unit.obj", face.mesh, scale));
    EXPECT_EQ(summary.unit, unit) << summary.unitFault;
    EXPECT_NEAR(summary.millimetres * scale, 1.0, 1e-9);
  }
  const mien::ScanSummary far = summaryOf(writeObj("far.obj", face.mesh, 1e5));
  EXPECT_EQ(far.unit, "");
  EXPECT_NE(far.unitFault.find("which no head does"), std::string::npos) << far.unitFault;
  EXPECT_TRUE(far.possibleUnits.empty());
}

/// The floor measures 191 from corner to corner, which alone would be a head in mm.
TEST(ScanSummary, GuessesTheUnitOfAFaceOnAFloor) {
  mien::TriangleMesh scan = DenseFace(101, 90).mesh;
  const auto vertices = scan.vertices.rows(), triangles = scan.triangles.rows();
  const int first = static_cast<int>(vertices);
  scan.vertices.conservativeResize(vertices + 4, 3);
  scan.vertices.bottomRows(4) << -675, -400, -675, 675, -400, -675, 675, -400, 675, -675, -400, 675;
  scan.triangles.conservativeResize(triangles + 2, 3);
  scan.triangles.bottomRows(2) << first, first + 2, first + 1, first, first + 3, first + 2;
  const mien::ScanSummary summary = summaryOf(writeObj("floor.obj", scan, 0.1));
  EXPECT_EQ(summary.unit, "cm") << summary.unitFault;
}

TEST(ScanSummary, RefusesWhatTheReaderRefuses) {
  mien::ScanSummary summary;
  summary.points = 7;
  EXPECT_EQ(mien::summarizeScan("/no/scan.ply", summary).rfind("/no/scan.ply: there is no such file", 0), 0u);
  EXPECT_EQ(summary.points, 7);
}
