#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "Program.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataReader.h"

namespace {

using nlohmann::json;

json continuityOf(const std::string& scheme) {
  const Outcome outcome = runMien({"continuity", "--scheme", scheme, "--json"});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
  return json::parse(outcome.output, nullptr, false);
}

TEST(ContinuityCommand, SmoothSchemesHaveNoAngleAtTheirSeams) {
  for (const char* const scheme : {"tangent", "curvature", "spline"}) {
    const json about = continuityOf(scheme);
    EXPECT_EQ(about["scheme"], scheme);
    EXPECT_EQ(about["modes"], 5);
    ASSERT_EQ(about["seams"].size(), 8u);
    EXPECT_EQ(about["seams"][0]["seam"], "P0|P1");
    for (const json& seam : about["seams"]) EXPECT_LT(seam["g1_max_deg"], 1e-6) << scheme << seam;
    EXPECT_LT(about["frontal"]["g1_max_deg"], 1e-6);
  }
}

TEST(ContinuityCommand, TheFourCurveSchemeFolds) {
  const json about = continuityOf("four-curve");
  EXPECT_GT(about["frontal"]["g1_mean_deg"], 30.0);
  EXPECT_LT(about["frontal"]["g0_max_mm"], 1e-9);
  for (const char* const key : {"g0_max_mm", "g1_mean_deg", "g1_max_deg", "c1_max", "g2_max_per_mm", "c2_max"})
    EXPECT_TRUE(about["seams"][3][key].is_number()) << key;
}

TEST(ContinuityCommand, AllSchemesGoIntoOneTableAndOneFigure) {
  const TemporaryFolder folder;
  const Outcome outcome =
      runMien({"continuity", "--scheme", "all", "-o", folder.file("a.csv"), "-o", folder.file("a.svg")});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  const std::string table = readTextFile(folder.file("a.csv")), figure = readTextFile(folder.file("a.svg"));
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 6 * 9);
  EXPECT_EQ(table.rfind("scheme,seam,g0_max_mm,", 0), 0u);
  for (const char* const part : {"four-curve", "spline", "P6|P7", "a = 1", "N = 5"})
    EXPECT_NE(figure.find(part), std::string::npos) << part;
  EXPECT_EQ(figure.find("<image"), std::string::npos);
  EXPECT_EQ(entriesIn(folder.file("")), 2);
}

TEST(ContinuityCommand, SeamsAreLinesWithTheirMeasures) {
  const TemporaryFolder folder;
  ASSERT_EQ(runMien({"continuity", "--samples", "50", "-o", folder.file("seams.vtp")}).exitCode, 0);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(folder.file("seams.vtp").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 8 * 50);
  EXPECT_TRUE(reader->GetOutput()->GetPointData()->HasArray("G1"));
}

TEST(ContinuityCommand, WrongValuesSayWhatIsAllowed) {
  const Outcome scheme = runMien({"continuity", "--scheme", "spline,cubic"});
  EXPECT_EQ(scheme.exitCode, 2);
  EXPECT_NE(scheme.errors.find("'cubic' is unknown; the known ones are four-curve"), std::string::npos)
      << scheme.errors;
  const Outcome several = runMien({"continuity", "--scheme", "all", "-o", "seams.vtp"});
  EXPECT_EQ(several.exitCode, 2);
  EXPECT_EQ(runMien({"continuity", "--width", "5"}).exitCode, 2);
  EXPECT_EQ(runMien({"continuity", "-o", "no/such/folder/a.svg"}).exitCode, 1);
}

}  // namespace
