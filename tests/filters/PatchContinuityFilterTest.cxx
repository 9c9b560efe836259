#include <gtest/gtest.h>

#include <cmath>

#include "BoundaryCurveData.h"
#include "ErrorCounter.h"
#include "RandomCurves.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPDEFaceFilter.h"
#include "vtkPatchContinuityFilter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkStructuredGrid.h"
#include "vtkTable.h"

namespace {

struct Seams {
  vtkNew<vtkPolyData> curves;
  vtkNew<vtkPatchContinuityFilter> filter;
  ErrorCounter errors{filter};

  explicit Seams(const mien::FaceCurves& face = randomFace()) {
    mien::writeFaceCurves(face, curves);
    filter->SetInputData(curves);
  }
  double summary(int row, const char* column) { return filter->GetSummary()->GetValueByName(row, column).ToDouble(); }
};

struct GenericSeams {
  vtkNew<vtkBoundaryCurveReader> reader;
  vtkNew<vtkPatchContinuityFilter> filter;

  explicit GenericSeams(const std::string& scheme) {
    filter->SetInputConnection(reader->GetOutputPort());
    filter->SetScheme(scheme);
    filter->Update();
  }
  double all(const char* column) { return filter->GetSummary()->GetValueByName(8, column).ToDouble(); }
};

constexpr int rowOfAll = 8;

}  // namespace

TEST(PatchContinuityFilter, GivesTheDocumentedLinesAndTable) {
  Seams seams;
  seams.filter->Update();
  EXPECT_EQ(seams.errors.count(), 0);
  vtkPolyData* lines = seams.filter->GetOutput();
  EXPECT_EQ(lines->GetNumberOfLines(), 8);
  EXPECT_EQ(lines->GetNumberOfPoints(), 8 * 400);
  for (const char* name : {"G0", "G1", "C1", "G2", "C2", "V"}) {
    ASSERT_NE(lines->GetPointData()->GetArray(name), nullptr) << name;
    EXPECT_EQ(lines->GetPointData()->GetArray(name)->GetNumberOfTuples(), 3200);
  }
  auto* names = vtkStringArray::SafeDownCast(lines->GetCellData()->GetAbstractArray("SeamName"));
  ASSERT_NE(names, nullptr);
  EXPECT_EQ(names->GetValue(6), "P6|P7");
  vtkNew<vtkIdList> ids;
  lines->GetLines()->GetCellAtId(3, ids);
  EXPECT_EQ(ids->GetNumberOfIds(), 401);
  EXPECT_EQ(ids->GetId(0), ids->GetId(400));
  EXPECT_NEAR(lines->GetPointData()->GetArray("V")->GetTuple1(500), 2.0 * M_PI * 100 / 400, 1e-12);
  vtkTable* table = seams.filter->GetSummary();
  EXPECT_EQ(table->GetNumberOfRows(), 9);
  EXPECT_EQ(table->GetNumberOfColumns(), 13);
  EXPECT_EQ(table->GetValueByName(rowOfAll, "seam").ToString(), "all");
}

TEST(PatchContinuityFilter, SeamsLieOnTheFace) {
  Seams seams;
  seams.filter->SetNumberOfSamples(40);
  seams.filter->Update();
  vtkNew<vtkPDEFaceFilter> face;
  face->SetInputData(seams.curves);
  face->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  face->SetResolution(29, 40);
  face->Update();
  const int rows[] = {3, 6, 9, 12, 15, 18, 21, 25};  // the second lip row follows the first
  for (int seam = 0; seam < 8; ++seam)
    for (int i = 0; i < 40; ++i)
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(seams.filter->GetOutput()->GetPoint(seam * 40 + i)[c],
                    face->GetOutput()->GetPoint(rows[seam] * 41 + i)[c], 1e-10);
}

TEST(PatchContinuityFilter, SummaryIsThatOfTheArrays) {
  Seams seams;
  seams.filter->SetScheme("four-curve");
  seams.filter->Update();
  vtkPolyData* lines = seams.filter->GetOutput();
  vtkDataArray* g1 = lines->GetPointData()->GetArray("G1");
  double allSum = 0.0, allFrontal = 0.0;
  int frontalCount = 0;
  for (int seam = 0; seam < 8; ++seam) {
    double sum = 0.0, largest = 0.0, frontal = 0.0;
    for (int i = 400 * seam; i < 400 * (seam + 1); ++i) {
      sum += g1->GetTuple1(i);
      largest = std::max(largest, g1->GetTuple1(i));
      if (!(lines->GetPoint(i)[2] > 50.0)) continue;
      frontal = std::max(frontal, g1->GetTuple1(i));
      allFrontal += g1->GetTuple1(i);
      ++frontalCount;
    }
    allSum += sum;
    EXPECT_NEAR(seams.summary(seam, "g1_mean_deg"), sum / 400, 1e-9);
    EXPECT_EQ(seams.summary(seam, "g1_max_deg"), largest);
    EXPECT_EQ(seams.summary(seam, "frontal_g1_max_deg"), frontal);
  }
  EXPECT_NEAR(seams.summary(rowOfAll, "g1_mean_deg"), allSum / 3200, 1e-9);
  EXPECT_NEAR(seams.summary(rowOfAll, "frontal_g1_mean_deg"), allFrontal / frontalCount, 1e-9);
}

// The generic face's mouth is closed, so P6|P7 is among the smooth seams.
TEST(PatchContinuityFilter, SmoothSchemesOfTheGenericFaceHaveNoFolds) {
  for (const std::string scheme : {"tangent", "curvature", "spline"}) {
    GenericSeams seams(scheme);
    EXPECT_LE(seams.all("g0_max_mm"), 1e-10) << scheme;
    EXPECT_LE(seams.all("g1_max_deg"), 1e-6) << scheme;
    if (scheme == "tangent") continue;
    EXPECT_LE(seams.all("c2_max"), 1e-7) << scheme;
    EXPECT_LE(seams.all("g2_max_per_mm"), 1e-7) << scheme;
  }
}

TEST(PatchContinuityFilter, FourCurveSeamsOfTheGenericFaceFold) {
  GenericSeams seams("four-curve");
  RecordProperty("frontal_g1_mean_deg", std::to_string(seams.all("frontal_g1_mean_deg")));
  EXPECT_LE(seams.all("g0_max_mm"), 1e-10);
  EXPECT_GE(seams.all("frontal_g1_mean_deg"), 20.0);
  EXPECT_GE(seams.all("frontal_g1_max_deg"), 90.0);
}

TEST(PatchContinuityFilter, SaysThatASeamHasNoFrontalPart) {
  mien::FaceCurves face = randomFace();
  face.curves.points.col(2).array() -= 200.0;
  Seams seams(face);
  seams.filter->Update();
  EXPECT_TRUE(std::isnan(seams.summary(2, "frontal_g1_max_deg")));
  EXPECT_TRUE(std::isnan(seams.summary(rowOfAll, "frontal_g0_max_mm")));
  EXPECT_FALSE(std::isnan(seams.summary(rowOfAll, "g0_max_mm")));
}

TEST(PatchContinuityFilter, PiecesShareTheSeamsOut) {
  for (const int pieces : {2, 3, 11}) {
    vtkIdType lines = 0;
    for (int piece = 0; piece < pieces; ++piece) {
      Seams seams;
      seams.filter->SetNumberOfSamples(20);
      seams.filter->UpdatePiece(piece, pieces, 0);
      lines += seams.filter->GetOutput()->GetNumberOfLines();
      EXPECT_EQ(seams.filter->GetOutput()->GetNumberOfPoints(), 20 * seams.filter->GetOutput()->GetNumberOfLines());
    }
    EXPECT_EQ(lines, 8);
  }
}

TEST(PatchContinuityFilter, RunsAgainOnlyWhenSomethingChanged) {
  Seams seams;
  int runs = 0;
  vtkNew<vtkCallbackCommand> counter;
  counter->SetClientData(&runs);
  counter->SetCallback([](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  seams.filter->AddObserver(vtkCommand::EndEvent, counter);
  seams.filter->Update();
  seams.filter->SetNumberOfSamples(400);
  seams.filter->SetScheme("spline");
  seams.filter->Update();
  EXPECT_EQ(runs, 1);
  seams.filter->SetNumberOfSamples(100);
  seams.filter->Update();
  EXPECT_EQ(runs, 2);
  mien::writeFaceCurves(randomFace(40, 2), seams.curves);
  seams.curves->Modified();
  seams.filter->Update();
  EXPECT_EQ(runs, 3);
  Seams fresh(randomFace(40, 2));
  fresh.filter->SetNumberOfSamples(100);
  fresh.filter->Update();
  EXPECT_EQ(seams.summary(4, "g2_max_per_mm"), fresh.summary(4, "g2_max_per_mm"));
}

TEST(PatchContinuityFilter, RefusesWhatIsNoFaceOrOutOfRange) {
  const auto refused = [](auto change, const char* word) {
    Seams seams;
    change(seams);
    seams.filter->Update();
    EXPECT_GE(seams.errors.count(), 1) << word;
    EXPECT_NE(seams.errors.first().find(word), std::string::npos) << seams.errors.first();
    EXPECT_EQ(seams.filter->GetOutput()->GetNumberOfPoints(), 0) << word;
    EXPECT_EQ(seams.filter->GetSummary()->GetNumberOfRows(), 0) << word;
  };
  refused([](Seams& s) { s.filter->SetNumberOfSamples(2); }, "3 .. 20000");
  refused([](Seams& s) { s.filter->SetNumberOfSamples(2000000000); }, "3 .. 20000");
  refused([](Seams& s) { s.filter->SetScheme("none"); }, "four-curve");
  refused([](Seams& s) { s.filter->SetNumberOfModes(21); }, "0 .. 20");
  refused([](Seams& s) { s.curves->Initialize(); }, "no lines");
}

TEST(PatchContinuityFilter, AnAbortedUpdateLeavesNoHalfOutput) {
  Seams seams;
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback(
      [](vtkObject* caller, unsigned long, void*, void*) { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  const auto observer = seams.filter->AddObserver(vtkCommand::ProgressEvent, abort);
  seams.filter->Update();
  EXPECT_EQ(seams.filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(seams.filter->GetSummary()->GetNumberOfRows(), 0);
  seams.filter->RemoveObserver(observer);
  seams.filter->SetAbortExecute(0);
  seams.filter->Modified();
  seams.filter->Update();
  EXPECT_EQ(seams.filter->GetOutput()->GetNumberOfPoints(), 3200);
}
