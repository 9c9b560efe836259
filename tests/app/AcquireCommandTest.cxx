#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "FaceFiles.h"
#include "Program.h"
#include "ReferenceData.h"
#include "SyntheticHead.h"

namespace {

/// A head and its landmarks, the lower lids at this height (mm); the upper ones are at 39 and 39.5.
void writeHead(const TemporaryFolder& folder, double lowerLids) {
  const SyntheticHead head = ellipticHead();
  const mien::TriangleMesh mesh = head.mesh();
  std::ofstream scan(folder.file("head.obj")), landmarks(folder.file("landmarks.csv"));
  scan.precision(12);
  landmarks.precision(12);
  for (int i = 0; i < mesh.vertices.rows(); ++i) scan << "v " << mesh.vertices.row(i) << "\n";
  for (int t = 0; t < mesh.triangles.rows(); ++t) scan << "f " << mesh.triangles.row(t).array() + 1 << "\n";
  landmarks << "landmark,x,y,z\n";
  const mien::FaceLandmarks places = head.landmarks();
  for (int i = 0; i < 68; ++i) {
    const bool isLowerLid = i == 40 || i == 41 || i == 46 || i == 47;
    const Eigen::Vector3d place = isLowerLid ? head.at(head.axis.azimuth(places[i]), lowerLids) : places[i];
    landmarks << i << "," << place.x() << "," << place.y() << "," << place.z() << "\n";
  }
}

Outcome acquireHead(const TemporaryFolder& folder) {
  return runMien({"acquire", folder.file("head.obj"), "--landmarks", folder.file("landmarks.csv"), "--points", "12",
                  "--json", "-o", folder.file("face.vtp")});
}

TEST(AcquireCommand, WrongUseIsRefused) {
  const TemporaryFolder folder;
  const std::string output = folder.file("face.vtp");
  EXPECT_EQ(runMien({"acquire", "-o", output}).exitCode, 2);
  EXPECT_EQ(runMien({"acquire", "a.ply", "--landmarks", "l.csv", "-o", folder.file("face.obj")}).exitCode, 2);
  EXPECT_EQ(runMien({"acquire", "a.ply", "b.ply", "--landmarks", "l.csv", "-o", output}).exitCode, 2);
  EXPECT_EQ(runMien({"acquire", "a.ply", "--landmarks", "l.csv", "--points", "41", "-o", output}).exitCode, 2);
  const Outcome missing = runMien({"acquire", "a.ply", "--landmarks", "l.csv", "-o", output});
  EXPECT_EQ(missing.exitCode, 1);
  EXPECT_EQ(missing.errors.rfind("mien: a.ply: ", 0), 0u) << missing.errors;
  EXPECT_EQ(entriesIn(folder.file("")), 0);
}

TEST(AcquireCommand, MeasuresAHead) {
  MIEN_REQUIRE_REFERENCE("heads/landmarks68.csv");
  const TemporaryFolder folder;
  const std::string heads = std::string(MIEN_REFERENCE_DIR) + "/heads/";
  const Outcome outcome = runMien({"acquire", heads + "subject01_neutral.ply", "--landmarks", heads + "landmarks68.csv",
                                   "--points", "48", "-o", folder.file("face.vtp")});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  vtkNew<vtkBoundaryCurveReader> reader;
  reader->SetFileName(folder.file("face.vtp").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 29 * 48);
}

TEST(AcquireCommand, CurvesThatCrossAreTold) {
  const TemporaryFolder folder;
  writeHead(folder, 31.0);
  const Outcome open = acquireHead(folder);
  ASSERT_EQ(open.exitCode, 0) << open.errors;
  EXPECT_EQ(nlohmann::json::parse(open.output)[0]["crossings"], 0);
  EXPECT_EQ(open.errors.find("curves cross"), std::string::npos) << open.errors;
  writeHead(folder, 38.5);  // too narrow for curves of twelve points, which cross between them
  const Outcome narrow = acquireHead(folder);
  ASSERT_EQ(narrow.exitCode, 0) << narrow.errors;
  const nlohmann::json report = nlohmann::json::parse(narrow.output)[0];
  EXPECT_GT(report["crossings"], 0);
  const std::string named = report["crossing_curves"];
  EXPECT_EQ(named.rfind("C9 and C10 (", 0), 0u) << named;
  EXPECT_NE(narrow.errors.find(folder.file("head.obj") + ": curves cross: " + named), std::string::npos)
      << narrow.errors;
}

}  // namespace
