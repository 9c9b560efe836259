#include <gtest/gtest.h>

#include <cmath>

#include "BoundaryCurveData.h"
#include "ErrorCounter.h"
#include "RandomCurves.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkPDEModeFilter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"
#include "vtkTable.h"

namespace {

struct Modes {
  vtkNew<vtkPolyData> curves;
  vtkNew<vtkPDEModeFilter> filter;
  ErrorCounter errors{filter};

  explicit Modes(const mien::FaceCurves& face = randomFace()) {
    mien::writeFaceCurves(face, curves);
    filter->SetInputData(curves);
    filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  }
  vtkStructuredGrid* grid() { return filter->GetOutput(); }
  double value(int row, const char* column) { return filter->GetSpectrum()->GetValueByName(row, column).ToDouble(); }
  std::array<double, 3> contribution(vtkIdType point) {
    std::array<double, 3> tuple;
    grid()->GetPointData()->GetArray("Contribution")->GetTuple(point, tuple.data());
    return tuple;
  }
};

}  // namespace

TEST(PDEModeFilter, GivesTheDocumentedGridAndTable) {
  Modes modes;
  modes.filter->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  modes.filter->Update();
  EXPECT_EQ(modes.errors.count(), 0);
  EXPECT_EQ(modes.grid()->GetNumberOfPoints(), 56 * 41);
  vtkDataArray* contribution = modes.grid()->GetPointData()->GetArray("Contribution");
  ASSERT_NE(contribution, nullptr);
  EXPECT_EQ(contribution->GetNumberOfComponents(), 3);
  EXPECT_EQ(contribution->GetDataType(), VTK_FLOAT);
  EXPECT_NE(modes.grid()->GetPointData()->GetArray("Normals"), nullptr);
  vtkTable* table = modes.filter->GetSpectrum();
  ASSERT_EQ(table->GetNumberOfRows(), 7);
  ASSERT_EQ(table->GetNumberOfColumns(), 5);
  EXPECT_EQ(table->GetValueByName(3, "mode").ToString(), "3");
  EXPECT_EQ(table->GetValueByName(6, "mode").ToString(), "remainder");
  double share = 0.0;
  for (int row = 0; row < 7; ++row) share += modes.value(row, "energy_share");
  EXPECT_NEAR(share, 1.0, 1e-14);
  EXPECT_EQ(modes.value(6, "cumulative_rms_error_mm"), 0.0);
}

TEST(PDEModeFilter, ContributionsSumToTheSurface) {
  Modes modes;
  std::vector<double> sum(56 * 41 * 3, 0.0);
  for (const int mode : {0, 1, 2, 3, 4, 5, -1}) {
    modes.filter->SetMode(mode);
    modes.filter->Update();
    for (vtkIdType i = 0; i < 56 * 41; ++i)
      for (int c = 0; c < 3; ++c) sum[3 * i + c] += modes.contribution(i)[c];
  }
  for (vtkIdType i = 0; i < 56 * 41; ++i)
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[3 * i + c], modes.grid()->GetPoint(i)[c], 1e-10);
}

TEST(PDEModeFilter, PartialSumsGrowByContributions) {
  Modes before, after;
  before.filter->PartialSumOn();
  after.filter->PartialSumOn();
  before.filter->SetMode(2);
  after.filter->SetMode(3);
  before.filter->Update();
  after.filter->Update();
  for (vtkIdType i = 0; i < 56 * 41; ++i)
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(before.grid()->GetPoint(i)[c] + after.contribution(i)[c], after.grid()->GetPoint(i)[c], 1e-10);
  Modes whole;
  after.filter->SetMode(-1);
  after.filter->Update();
  whole.filter->Update();
  for (vtkIdType i = 0; i < 56 * 41; ++i) EXPECT_EQ(after.grid()->GetPoint(i)[2], whole.grid()->GetPoint(i)[2]);
}

TEST(PDEModeFilter, PiecesEqualTheWholeAndTheFirstHasItsTable) {
  Modes whole;
  whole.filter->SetMode(4);
  whole.filter->Update();
  for (int piece = 0; piece < 3; ++piece) {
    Modes part;
    part.filter->SetMode(4);
    part.filter->UpdatePiece(piece, 3, 0);
    int extent[6];
    part.grid()->GetExtent(extent);
    EXPECT_LT(part.grid()->GetNumberOfPoints(), 56 * 41);
    EXPECT_GT(part.grid()->GetNumberOfPoints(), 0);
    vtkIdType i = 0;
    for (int row = extent[2]; row <= extent[3]; ++row)
      for (int column = extent[0]; column <= extent[1]; ++column, ++i)
        ASSERT_EQ(part.contribution(i), whole.contribution(row * 41 + column)) << row << " " << column;
    ASSERT_EQ(part.filter->GetSpectrum()->GetNumberOfRows(), piece == 0 ? 7 : 0);
    for (int row = 0; row < 7 && piece == 0; ++row) EXPECT_EQ(part.value(row, "rms_mm"), whole.value(row, "rms_mm"));
  }
}

TEST(PDEModeFilter, RemainderVanishesWithAllModes) {
  Modes modes;
  modes.filter->SetNumberOfModes(20);
  modes.filter->SetMode(-1);
  modes.filter->Update();
  EXPECT_EQ(modes.filter->GetSpectrum()->GetNumberOfRows(), 22);
  EXPECT_EQ(modes.value(21, "max_mm"), 0.0);
  for (vtkIdType i = 0; i < 56 * 41; ++i) EXPECT_EQ(modes.contribution(i), (std::array<double, 3>{0.0, 0.0, 0.0}));
}

TEST(PDEModeFilter, FindsTheSmallestNumberOfModes) {
  Modes modes;
  modes.filter->SetNumberOfModes(20);
  modes.filter->Update();
  const int found = modes.filter->FindNumberOfModes(1.0);
  EXPECT_LE(modes.value(found, "cumulative_rms_error_mm"), 1.0);
  EXPECT_GT(modes.value(found - 1, "cumulative_rms_error_mm"), 1.0);
  EXPECT_EQ(modes.filter->FindNumberOfModes(0.0), 20);
  EXPECT_EQ(modes.filter->FindNumberOfModes(1000.0), 0);
  Modes five;  // asks before any update, and with fewer modes than needed
  EXPECT_EQ(five.filter->FindNumberOfModes(1.0), found);
  EXPECT_EQ(modes.errors.count() + five.errors.count(), 0);
}

TEST(PDEModeFilter, FindingModesRefusesWhatHasNoAnswer) {
  Modes modes;
  EXPECT_EQ(modes.filter->FindNumberOfModes(-1.0), -1);
  EXPECT_NE(modes.errors.first().find("-1 mm"), std::string::npos);
  Modes steep;
  steep.filter->SetScheme("four-curve");
  steep.filter->SetSmoothing(20.0);
  EXPECT_EQ(steep.filter->FindNumberOfModes(1.0), -1);
  EXPECT_NE(steep.errors.first().find("250"), std::string::npos);
  Modes coarse;
  coarse.filter->SetResolution(2, 2);
  EXPECT_EQ(coarse.filter->FindNumberOfModes(1.0), -1);
  vtkNew<vtkPDEModeFilter> empty;
  ErrorCounter errors(empty);
  EXPECT_EQ(empty->FindNumberOfModes(1.0), -1);
  EXPECT_EQ(errors.count(), 1);
}

TEST(PDEModeFilter, RunsAgainOnlyWhenSomethingChanged) {
  Modes modes;
  int runs = 0;
  vtkNew<vtkCallbackCommand> counter;
  counter->SetClientData(&runs);
  counter->SetCallback([](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  modes.filter->AddObserver(vtkCommand::EndEvent, counter);
  modes.filter->Update();
  modes.filter->SetMode(0);
  modes.filter->PartialSumOff();
  modes.filter->Update();
  EXPECT_EQ(runs, 1);
  modes.filter->SetMode(1);
  modes.filter->Update();
  EXPECT_EQ(runs, 2);
  mien::writeFaceCurves(randomFace(40, 2), modes.curves);
  modes.curves->Modified();
  modes.filter->SetResolution(80, 31);
  modes.filter->Update();
  EXPECT_EQ(runs, 3);
  Modes fresh(randomFace(40, 2));
  fresh.filter->SetMode(1);
  fresh.filter->SetResolution(80, 31);
  fresh.filter->Update();
  EXPECT_EQ(modes.value(6, "max_mm"), fresh.value(6, "max_mm"));
  EXPECT_EQ(modes.contribution(1000), fresh.contribution(1000));
}

TEST(PDEModeFilter, RefusesWhatIsNoFaceOrOutOfRange) {
  const auto refused = [](auto change, const char* word) {
    Modes modes;
    change(modes);
    modes.filter->Update();
    EXPECT_GE(modes.errors.count(), 1) << word;
    EXPECT_NE(modes.errors.first().find(word), std::string::npos) << modes.errors.first();
    EXPECT_EQ(modes.grid()->GetNumberOfPoints(), 0) << word;
    EXPECT_EQ(modes.filter->GetSpectrum()->GetNumberOfRows(), 0) << word;
  };
  refused([](Modes& m) { m.filter->SetMode(6); }, "0 .. 5");
  refused([](Modes& m) { m.filter->SetMode(-2); }, "-1 for the remainder");
  refused(
      [](Modes& m) {
        m.filter->SetMode(-1);
        m.filter->RemainderOff();
      },
      "has none");
  refused([](Modes& m) { m.filter->SetResolution(10, 40); }, "11x3");
  refused([](Modes& m) { m.filter->SetScheme("none"); }, "four-curve");
  refused([](Modes& m) { m.curves->Initialize(); }, "no lines");
}

TEST(PDEModeFilter, AnAbortedUpdateLeavesNoHalfOutput) {
  Modes modes;
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback(
      [](vtkObject* caller, unsigned long, void*, void*) { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  const auto observer = modes.filter->AddObserver(vtkCommand::ProgressEvent, abort);
  modes.filter->Update();
  EXPECT_EQ(modes.grid()->GetNumberOfPoints(), 0);
  EXPECT_EQ(modes.filter->GetSpectrum()->GetNumberOfRows(), 0);
  modes.filter->RemoveObserver(observer);
  modes.filter->SetAbortExecute(0);
  modes.filter->Modified();
  modes.filter->Update();
  EXPECT_EQ(modes.grid()->GetNumberOfPoints(), 56 * 41);
}

TEST(PDEModeFilter, AnAbortAtTheEndLeavesBothPortsEmpty) {
  Modes modes;
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*) {
    auto* filter = static_cast<vtkAlgorithm*>(caller);
    if (filter->GetProgress() >= 1.0) filter->SetAbortExecute(1);
  });
  modes.filter->AddObserver(vtkCommand::ProgressEvent, abort);
  modes.filter->Update();
  EXPECT_EQ(modes.grid()->GetNumberOfPoints(), 0);
  EXPECT_EQ(modes.filter->GetSpectrum()->GetNumberOfRows(), 0);
}
