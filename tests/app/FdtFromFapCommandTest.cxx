#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "DataFile.h"
#include "Program.h"
#include "TableFiles.h"
#include "vtkNew.h"
#include "vtkStructuredGrid.h"
#include "vtkXMLStructuredGridReader.h"

using nlohmann::json;

namespace {

using Grid = vtkSmartPointer<vtkStructuredGrid>;

Grid surface(std::vector<std::string> options) {
  const TemporaryFolder folder;
  options.insert(options.begin(), {"surface", "-o", folder.file("s.vts")});
  const Outcome outcome = runMien(options);
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
  vtkNew<vtkXMLStructuredGridReader> reader;
  reader->SetFileName(folder.file("s.vts").c_str());
  reader->Update();
  return reader->GetOutput();
}

/// RMS of what is left of a movement in the plane of the face, against the movement itself, over points that move by
/// more than 0.5 mm.
double shareLeft(const std::string& expression, const std::string& table) {
  const Grid neutral = surface({}), moved = surface({"--expression", expression}), tabled = surface({"--fdt", table});
  double left = 0.0, whole = 0.0;
  for (vtkIdType i = 0; i < neutral->GetNumberOfPoints(); ++i) {
    const Eigen::Vector2d n = Eigen::Vector3d(neutral->GetPoint(i)).head<2>(),
                          m = Eigen::Vector3d(moved->GetPoint(i)).head<2>(),
                          t = Eigen::Vector3d(tabled->GetPoint(i)).head<2>();
    if ((m - n).norm() < 0.5) continue;
    left += (t - m).squaredNorm();
    whole += (m - n).squaredNorm();
  }
  return std::sqrt(left / whole);
}

}  // namespace

TEST(FdtFromFapCommand, TheTableMovesTheFaceAsTheExpressionDoes) {
  for (const char* const expression : {"joy", "surprise"}) {
    const TemporaryFolder folder;
    const std::string table = folder.file("t.csv");
    const Outcome outcome = runMien({"fdt", "from-fap", expression, "-o", table, "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
    const json about = json::parse(outcome.output);
    ASSERT_EQ(about["regions"].size(), 16u);
    for (const json& region : about["regions"]) EXPECT_GT(region["points"], 50);
    const double left = shareLeft(expression, table);
    RecordProperty(expression, std::to_string(left));
    EXPECT_LT(left, 0.35) << expression;
  }
}

TEST(FdtFromFapCommand, IntensityScalesAndFramesAreTaken) {
  const TemporaryFolder folder;
  ASSERT_EQ(runMien({"fdt", "from-fap", "joy:0.5", "-o", folder.file("half.csv")}).exitCode, 0);
  const Outcome named =
      runMien({"fdt", "classify", folder.file("half.csv"), "--against", "joy", "sadness", "anger", "--json"});
  EXPECT_EQ(json::parse(named.output)["expression"], "joy");
  const Outcome frame = runMien({"fdt", "from-fap", "--fap", std::string(MIEN_DATA_DIR) + "/animation/demo.fap",
                                 "--index", "40", "-o", folder.file("frame.csv")});
  ASSERT_EQ(frame.exitCode, 0) << frame.errors;
  tableFrom(folder.file("frame.csv"));
  const Outcome nothing = runMien({"fdt", "from-fap", "-o", folder.file("n.csv")});
  EXPECT_EQ(nothing.exitCode, 2);
  EXPECT_NE(nothing.errors.find("nothing moves the face"), std::string::npos);
  EXPECT_EQ(runMien({"fdt", "from-fap", "glee", "-o", folder.file("n.csv")}).exitCode, 2);
  EXPECT_EQ(entriesIn(folder.file("")), 2);
}
