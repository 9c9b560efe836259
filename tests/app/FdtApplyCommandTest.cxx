#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "CsvRows.h"
#include "NamedTables.h"
#include "Program.h"
#include "SampleRecording.h"
#include "TableFiles.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLStructuredGridReader.h"

using nlohmann::json;
using Axes = SampleRecording::Axes;

namespace {

const SampleRecording& still() {
  static const SampleRecording recording{mien::DeformationTable()};
  return recording;
}

mien::PointTable pointsFrom(const std::string& file) {
  mien::PointTable points;
  EXPECT_EQ(points.parse(readTextFile(file)), "") << file;
  return points;
}

double largestDistance(vtkPointSet* a, vtkPointSet* b) {
  EXPECT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  double largest = 0.0;
  for (vtkIdType i = 0; i < std::min(a->GetNumberOfPoints(), b->GetNumberOfPoints()); ++i)
    largest = std::max(largest, (Eigen::Vector3d(a->GetPoint(i)) - Eigen::Vector3d(b->GetPoint(i))).norm());
  return largest;
}

}  // namespace

TEST(FdtApplyCommand, AFitOfWhatWasAppliedIsTheTableWithinTheFace) {
  for (const Axes axes : {Axes::Millimetres, Axes::Pixels}) {
    const TemporaryFolder folder;
    const std::string before = folder.file("a.csv"), after = folder.file("b.csv"), table = folder.file("t.csv");
    writeTextFile(before, still().state(false, axes));
    std::vector<std::string> apply = {"fdt", "apply", "joy", before, "--hard", "-o", after},
                             fit = {"fdt", "fit", "--neutral", before, "--expression", after, "-o", table};
    if (axes == Axes::Pixels) {
      apply.push_back("--y-down");
      fit.push_back("--y-down");
    }
    const Outcome applied = runMien(apply), fitted = runMien(fit);
    ASSERT_EQ(applied.exitCode, 0) << applied.errors;
    ASSERT_EQ(fitted.exitCode, 0) << fitted.errors;
    // The other regions reach the outline, near which movement fades.
    const mien::DeformationTable found = tableFrom(table), wanted = *mien::namedTable("joy");
    for (const int region : {3, 8, 9, 12, 13})
      EXPECT_LT((found.maps[region - 1].coefficients - wanted.maps[region - 1].coefficients).cwiseAbs().maxCoeff(),
                1e-9)
          << region;
  }
}

TEST(FdtApplyCommand, StrengthScalesAndPupilsStay) {
  const TemporaryFolder folder;
  writeTextFile(folder.file("a.csv"), still().state(false));
  const auto moved = [&](const std::string& strength) {
    const Outcome outcome = runMien({"fdt", "apply", "surprise", folder.file("a.csv"), "--strength", strength, "-o",
                                     folder.file(strength + ".csv")});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
    return pointsFrom(folder.file(strength + ".csv"));
  };
  const mien::PointTable before = pointsFrom(folder.file("a.csv")), none = moved("0"), half = moved("0.5"),
                         full = moved("1");
  double largest = 0.0;
  for (std::size_t i = 0; i < before.points.size(); ++i) {
    const Eigen::Vector3d &p = before.points[i].position, move = full.points[i].position - p;
    EXPECT_EQ(none.points[i].position, p);
    EXPECT_LT((half.points[i].position - p - 0.5 * move).norm(), 1e-10);
    EXPECT_EQ(move.z(), 0.0);
    if (i < 2) {
      EXPECT_EQ(move.norm(), 0.0) << "a pupil";
    }
    largest = std::max(largest, move.norm());
  }
  EXPECT_GT(largest, 5.0);
}

TEST(FdtApplyCommand, MissingMarkersStayMissing) {
  const TemporaryFolder folder;
  writeTextFile(folder.file("a.csv"),
                "marker,x,y,region\npupil_left,30,0,\npupil_right,-30,0,\nnose,,,\nlip,0,-60,12\n");
  const Outcome outcome = runMien({"fdt", "apply", "joy", folder.file("a.csv"), "--json", "-o", folder.file("b.csv")});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  const std::string text = readTextFile(folder.file("b.csv"));
  EXPECT_EQ(text.rfind("marker,x,y,region\npupil_left,30,0,\npupil_right,-30,0,\nnose,,,\nlip,", 0), 0u) << text;
  EXPECT_EQ(json::parse(outcome.output)["points"], 3);
}

TEST(FdtApplyCommand, WeightsAddUpAsABlendedTableDoes) {
  const TemporaryFolder folder;
  writeTextFile(folder.file("a.csv"), still().state(false));
  ASSERT_EQ(runMien({"fdt", "blend", "joy:0.5", "surprise:0.25", "-o", folder.file("t.csv")}).exitCode, 0);
  ASSERT_EQ(
      runMien({"fdt", "apply", "joy:0.5", "surprise:0.25", folder.file("a.csv"), "-o", folder.file("b.csv")}).exitCode,
      0);
  ASSERT_EQ(runMien({"fdt", "apply", folder.file("t.csv"), folder.file("a.csv"), "-o", folder.file("c.csv")}).exitCode,
            0);
  EXPECT_EQ(readTextFile(folder.file("b.csv")), readTextFile(folder.file("c.csv")));
}

TEST(FdtApplyCommand, TheFaceInAFileMovesAsInThePipeline) {
  const TemporaryFolder folder;
  const std::string neutral = folder.file("n.vts"), piped = folder.file("p.vts"), applied = folder.file("a.vts");
  ASSERT_EQ(runMien({"surface", "-o", neutral}).exitCode, 0);
  ASSERT_EQ(runMien({"surface", "--fdt", "joy", "-o", piped}).exitCode, 0);
  const Outcome outcome = runMien({"fdt", "apply", "joy", neutral, "-o", applied});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");
  vtkNew<vtkXMLStructuredGridReader> a, b, n;
  a->SetFileName(applied.c_str());
  b->SetFileName(piped.c_str());
  n->SetFileName(neutral.c_str());
  for (vtkXMLStructuredGridReader* reader : {a.Get(), b.Get(), n.Get()}) reader->Update();
  EXPECT_LT(largestDistance(a->GetOutput(), b->GetOutput()), 1e-4);
  EXPECT_GT(largestDistance(a->GetOutput(), n->GetOutput()), 3.0);
}

TEST(FdtApplyCommand, HeadsOfEveryFormatTakePupilsByPlace) {
  const TemporaryFolder folder;
  for (const char* const ending : {"ply", "obj", "stl", "vtp"}) {
    const std::string head = folder.file(std::string("head.") + ending),
                      out = folder.file(std::string("out.") + ending);
    ASSERT_EQ(runMien({"surface", "-o", head}).exitCode, 0);
    const Outcome outcome =
        runMien({"fdt", "apply", "joy", head, "--pupils", "31,37,82,-31,37,82", "--json", "-o", out});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
    EXPECT_NE(outcome.errors.find("--landmarks"), std::string::npos) << "a head without sides of the lips is told";
    const json about = json::parse(outcome.output);
    EXPECT_GT(about["largest_displacement"], 3.0);
    EXPECT_GT(about["moved"], 500);
    EXPECT_GT(readTextFile(out).size(), 10000u);
  }
}

TEST(FdtApplyCommand, PolygonsAndWhatElseTheFileSaysAreKept) {
  const TemporaryFolder folder;
  ASSERT_EQ(runMien({"surface", "-o", folder.file("a.ply"), "--resolution", "40x30"}).exitCode, 0);
  ASSERT_EQ(runMien({"surface", "-o", folder.file("a.obj"), "--resolution", "40x30"}).exitCode, 0);
  std::string text = readTextFile(folder.file("a.obj"));
  const std::size_t quad = text.find("\nf ");
  text.insert(quad + 1, "vt 0.25 0.5\ng skin\nusemtl rough\n");
  writeTextFile(folder.file("b.obj"), text);
  for (const char* name : {"a.ply", "b.obj"}) {
    const std::string moved = folder.file(std::string("moved_") + name);
    const Outcome outcome =
        runMien({"fdt", "apply", "joy", folder.file(name), "--pupils", "31,37,83,-31,37,83", "-o", moved});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
    const std::string result = readTextFile(moved), source = readTextFile(folder.file(name));
    const auto faces = [](const std::string& file) { return file.substr(file.find("element face"), 25); };
    if (std::string(name) == "a.ply") {
      EXPECT_EQ(faces(result), faces(source)) << "quads are no triangles";
    }
    if (std::string(name) == "b.obj") {
      EXPECT_EQ(result.substr(result.find("vt 0.25")), source.substr(source.find("vt 0.25")));
    }
    EXPECT_NE(result, source);
  }
  const std::string off = folder.file("a.off");
  ASSERT_EQ(
      runMien({"fdt", "apply", "joy", folder.file("a.ply"), "--pupils", "31,37,83,-31,37,83", "-o", off}).exitCode, 0);
  EXPECT_EQ(runMien({"compare", off, folder.file("moved_a.ply"), "--json"}).exitCode, 0);
}

TEST(FdtApplyCommand, CurvesMoveWithoutCrossing) {
  const TemporaryFolder folder;
  ASSERT_EQ(runMien({"curves", "-o", folder.file("c.vtp")}).exitCode, 0);
  for (const char* table : {"joy", "sadness", "surprise", "smile"}) {
    const Outcome outcome = runMien({"fdt", "apply", table, folder.file("c.vtp"), "-o", folder.file("d.vtp")});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
    EXPECT_EQ(outcome.errors, "") << "no landmarks are wanted, and all the movement is kept";
    EXPECT_EQ(runMien({"info", folder.file("d.vtp")}).exitCode, 0) << table;
    EXPECT_EQ(runMien({"curves", "--fdt", table, "-o", folder.file("e.mienz")}).exitCode, 0) << table;
  }
}

TEST(FdtApplyCommand, ErrorsSayWhatToDoAndLeaveNothing) {
  const TemporaryFolder folder;
  writeTextFile(folder.file("a.csv"), "marker,x,y\npupil_left,30,0\nlip,0,-60\n");
  const auto expect = [&](std::vector<std::string> words, int exitCode, const std::string& part) {
    words.insert(words.begin(), {"fdt", "apply"});
    const Outcome outcome = runMien(words);
    EXPECT_EQ(outcome.exitCode, exitCode) << outcome.errors;
    EXPECT_NE(outcome.errors.find(part), std::string::npos) << outcome.errors;
  };
  const std::string out = folder.file("o.csv");
  expect({"joy", folder.file("a.csv"), "-o", out}, 1, "a.csv:1: the pupil pupil_right is missing");
  expect({"joy", folder.file("a.csv"), "--pupils", "pupil_left,pupil_left", "-o", out}, 1, "coincide");
  expect({"nope", folder.file("a.csv"), "-o", out}, 1, "there are the tables anger");
  expect({"joy:x", folder.file("a.csv"), "-o", out}, 2, "'joy:x'");
  expect({"joy", folder.file("a.csv"), "-o", folder.file("o.ply")}, 2, ".csv");
  expect({"joy", folder.file("a.csv"), "--strength", "9", "-o", out}, 2, "-2 .. 2");
  expect({folder.file("a.csv"), "-o", out}, 2, "give a table and a face");
  const TemporaryFolder heads;
  const std::string head = heads.file("head.ply"), moved = folder.file("o.ply");
  ASSERT_EQ(runMien({"surface", "-o", head}).exitCode, 0);
  expect({"joy", head, "-o", moved}, 1, "head.ply: nothing tells where its pupils are; give the 68 landmarks (--land");
  expect({"joy", head, "--pupils", "31,37,-31,37", "-o", moved}, 2, "'31,37,-31,37' are no places of a surface");
  expect({"joy", head, "--pupils", "-31,37,82,31,37,82", "-o", moved}, 1, "head.ply: the nose lies above the eyes");
  expect({"joy", folder.file("none.ply"), "-o", folder.file("o.ply")}, 1, "there is no such file");
  EXPECT_EQ(entriesIn(folder.file("")), 1);
}
