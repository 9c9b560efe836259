#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "BoundaryCurveData.h"
#include "ErrorCounter.h"
#include "FaceAcquisition.h"
#include "MeshPolyData.h"
#include "ReferenceData.h"
#include "SyntheticHead.h"
#include "vtkBoundaryCurveAcquisitionFilter.h"
#include "vtkCallbackCommand.h"
#include "vtkLevelOfDetailFilter.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkScanReader.h"
#include "vtkTable.h"

namespace {

/// A smooth head of known shape and the curves measured on it.
struct ReducedHead {
  vtkNew<vtkPolyData> curves, scan;

  explicit ReducedHead(int pointsPerCurve = 12) {
    const SyntheticHead head = ellipticHead();
    const mien::TriangleMesh mesh = head.mesh();
    mien::FaceCurves face;
    EXPECT_EQ(mien::acquireFace(mesh, head.landmarks(), pointsPerCurve, face), "");
    mien::writeFaceCurves(face, curves);
    fillPolyData(mesh, scan);
  }

  void connect(vtkLevelOfDetailFilter* filter) const {
    filter->SetInputData(curves);
    filter->SetScanData(scan);
    filter->SetTolerances({0.1, 1.0});
    filter->SetSampleSpacing(5.0);
  }
};

struct Row {
  std::string representation, detail;
  std::map<std::string, double> numbers;
  double operator[](const char* name) const { return numbers.at(name); }
};

std::vector<Row> rowsOf(vtkTable* table, const std::string& representation) {
  std::vector<Row> rows;
  for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i) {
    Row row{table->GetValueByName(i, "representation").ToString(), table->GetValueByName(i, "detail").ToString(), {}};
    for (vtkIdType c = 2; c < table->GetNumberOfColumns(); ++c)
      row.numbers[table->GetColumnName(c)] = table->GetValue(i, c).ToDouble();
    if (row.representation == representation) rows.push_back(row);
  }
  return rows;
}

/// What several tests look at is measured once.
vtkTable* levelsOfTheHead() {
  static const vtkNew<vtkTable> table = [] {
    const ReducedHead head;
    vtkNew<vtkLevelOfDetailFilter> filter;
    head.connect(filter);
    filter->Update();
    vtkNew<vtkTable> levels;
    levels->ShallowCopy(filter->GetOutput());
    return levels;
  }();
  return table;
}

}  // namespace

TEST(LevelOfDetailFilter, CountsBytesAsThePaperDoesAndMeshesOfTheSameSize) {
  vtkTable* table = levelsOfTheHead();
  ASSERT_EQ(rowsOf(table, "PDE face").size(), 1u);
  EXPECT_EQ(rowsOf(table, "PDE face")[0]["bytes"], 29 * 12 * 3 * 4);
  const std::vector<Row> modes = rowsOf(table, "modes");
  ASSERT_EQ(modes.size(), 6u);
  for (int n = 1; n <= 6; ++n) EXPECT_EQ(modes[n - 1]["bytes"], 29 * std::min(2 * n + 1, 12) * 12) << n;
  ASSERT_EQ(rowsOf(table, "compact face").size(), 2u);
  const std::vector<Row> plain = rowsOf(table, "decimated mesh"), packed = rowsOf(table, "packed mesh");
  ASSERT_EQ(plain.size(), 7u);  // 3,828 bytes are too near 4,176 for a mesh of their own
  ASSERT_EQ(packed.size(), 7u);
  EXPECT_NEAR(plain[0]["bytes"] / rowsOf(table, "PDE face")[0]["bytes"], 1.0, 0.1);
  EXPECT_GT(packed[0]["triangles"], 1.5 * plain[0]["triangles"]);
}

TEST(LevelOfDetailFilter, MoreBytesAreLessErrorAndBothWaysAgree) {
  vtkTable* table = levelsOfTheHead();
  for (const char* const representation : {"modes", "decimated mesh", "packed mesh"}) {
    const std::vector<Row> rows = rowsOf(table, representation);
    const Row& most = std::string(representation) == "modes" ? rows.back() : rows.front();
    const Row& least = std::string(representation) == "modes" ? rows.front() : rows.back();
    EXPECT_LT(most["symmetric_rms_mm"], 0.5 * least["symmetric_rms_mm"]) << representation;
    for (const Row& row : rows) {
      EXPECT_GE(row["max_mm"], row["rms_mm"]);
      EXPECT_EQ(row["hausdorff_mm"], std::max(row["max_mm"], row["back_max_mm"]));
      EXPECT_EQ(row["symmetric_rms_mm"], std::max(row["rms_mm"], row["back_rms_mm"]));
    }
  }
  // all modes are the face itself
  const Row face = rowsOf(table, "PDE face")[0], all = rowsOf(table, "modes").back();
  EXPECT_NEAR(all["rms_mm"], face["rms_mm"], 1e-9);
  EXPECT_LT(all["curves_rms_mm"], 1e-9);
  EXPECT_LE(rowsOf(table, "compact face")[0]["curves_rms_mm"], 0.1);
}

TEST(LevelOfDetailFilter, AFlatCutOfTheHeadIsMeasuredExactly) {
  // the scan moved out along z by 1 mm: what faces forward is 1 mm away, and nothing further
  const ReducedHead head(10);
  vtkNew<vtkLevelOfDetailFilter> filter;
  head.connect(filter);
  filter->SetTolerances({1.0});
  filter->SetSampleSpacing(8.0);
  filter->Update();
  const double before = rowsOf(filter->GetOutput(), "PDE face")[0]["max_mm"];
  vtkNew<vtkPoints> moved;
  moved->DeepCopy(head.scan->GetPoints());
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i) {
    double p[3];
    moved->GetPoint(i, p);
    moved->SetPoint(i, p[0], p[1], p[2] + 10.0);
  }
  vtkNew<vtkPolyData> scan;
  scan->ShallowCopy(head.scan);
  scan->SetPoints(moved);
  filter->SetScanData(scan);
  filter->Update();
  const Row row = rowsOf(filter->GetOutput(), "PDE face")[0];
  EXPECT_LE(row["max_mm"], 10.0 + before);
  EXPECT_GE(row["max_mm"], 10.0 - before);
  EXPECT_LE(row["back_max_mm"], 10.0 + before);
}

TEST(LevelOfDetailFilter, StopsWhenItIsToldTo) {
  const ReducedHead head;
  vtkNew<vtkLevelOfDetailFilter> filter;
  head.connect(filter);
  double last = -1.0;
  vtkNew<vtkCallbackCommand> stop;
  stop->SetClientData(&last);
  stop->SetCallback([](vtkObject* caller, unsigned long, void* data, void*) {
    auto* algorithm = static_cast<vtkAlgorithm*>(caller);
    auto& progress = *static_cast<double*>(data);
    EXPECT_GE(algorithm->GetProgress(), progress);
    progress = algorithm->GetProgress();
    if (progress > 0.2) algorithm->SetAbortExecute(1);
  });
  filter->AddObserver(vtkCommand::ProgressEvent, stop);
  filter->Update();
  EXPECT_GT(last, 0.0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfRows(), 0);
}

TEST(LevelOfDetailFilter, RunsAgainOnlyWhenSomethingChanged) {
  const ReducedHead head(10);
  vtkNew<vtkLevelOfDetailFilter> filter;
  head.connect(filter);
  filter->SetTolerances({1.0});
  filter->SetFrontalThreshold(90.0);
  filter->Update();
  ASSERT_GT(filter->GetOutput()->GetNumberOfRows(), 0);
  vtkMTimeType before = filter->GetOutput()->GetMTime();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetMTime(), before);
  const auto expectRun = [&](const char* what) {
    filter->Update();
    EXPECT_GT(filter->GetOutput()->GetMTime(), before) << what;
    EXPECT_GT(filter->GetOutput()->GetNumberOfRows(), 0) << what;
    before = filter->GetOutput()->GetMTime();
  };
  filter->SetTolerances({0.5});
  expectRun("tolerances");
  filter->SetFrontalThreshold(95.0);
  expectRun("threshold");
  filter->SetSampleSpacing(6.0);
  expectRun("spacing");
  filter->SetScheme("four-curve");
  expectRun("scheme");
}

TEST(LevelOfDetailFilter, WrongInputIsAnErrorWithoutATable) {
  const ReducedHead head(10);
  const auto fault = [&](const std::function<void(vtkLevelOfDetailFilter*)>& change) {
    vtkNew<vtkLevelOfDetailFilter> filter;
    ErrorCounter errors(filter);
    head.connect(filter);
    change(filter);
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfRows(), 0);
    return errors.first();
  };
  EXPECT_NE(fault([](auto* f) { f->SetScanData(vtkNew<vtkPolyData>()); }), "");
  EXPECT_NE(fault([](auto* f) { f->SetInputData(vtkNew<vtkPolyData>()); }).find("no lines"), std::string::npos);
  EXPECT_NE(fault([](auto* f) { f->SetTolerances({}); }).find("no tolerance"), std::string::npos);
  EXPECT_NE(fault([](auto* f) { f->SetTolerances({-1.0}); }).find("tolerance of -1 mm"), std::string::npos);
  EXPECT_NE(fault([](auto* f) { f->SetSampleSpacing(0.0); }).find("spacing of 0 mm"), std::string::npos);
  EXPECT_NE(fault([](auto* f) { f->SetFrontalThreshold(500.0); }).find("z = 500 mm"), std::string::npos);
  EXPECT_NE(fault([](auto* f) { f->SetNumberOfModes(50); }), "");
}

TEST(LevelOfDetailFilter, ACompactFaceIsNearerToAScannedHeadThanAMeshOfItsSize) {
  MIEN_REQUIRE_REFERENCE("heads/subject01_neutral.ply");
  vtkNew<vtkScanReader> scan;
  scan->SetFileName(referencePath("heads/subject01_neutral.ply").c_str());
  vtkNew<vtkBoundaryCurveAcquisitionFilter> curves;
  curves->SetInputConnection(scan->GetOutputPort());
  curves->SetLandmarkFileName(referencePath("heads/landmarks68.csv").c_str());
  vtkNew<vtkLevelOfDetailFilter> filter;
  filter->SetInputConnection(curves->GetOutputPort());
  filter->SetScanConnection(scan->GetOutputPort());
  filter->SetTolerances({0.1});
  filter->SetSampleSpacing(5.0);
  filter->Update();
  const Row face = rowsOf(filter->GetOutput(), "PDE face")[0], compact = rowsOf(filter->GetOutput(), "compact face")[0];
  EXPECT_LE(face["rms_mm"], 0.7);
  EXPECT_LE(compact["bytes"], 2500);
  EXPECT_LE(compact["rms_mm"], face["rms_mm"] + 0.1);
  for (const char* const mesh : {"decimated mesh", "packed mesh"})
    for (const Row& row : rowsOf(filter->GetOutput(), mesh))
      if (row["bytes"] <= 1.1 * compact["bytes"]) {
        EXPECT_GT(row["symmetric_rms_mm"], compact["symmetric_rms_mm"]) << mesh << " " << row.detail;
      }
}
