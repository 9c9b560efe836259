#include <gtest/gtest.h>

#include <cmath>

#include "ErrorCounter.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPDEFaceFilter.h"
#include "vtkPDEInfluenceFilter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"
#include "vtkTable.h"
#include "vtkVariant.h"

namespace {

struct Influence {
  vtkNew<vtkBoundaryCurveReader> curves;
  vtkNew<vtkPDEInfluenceFilter> filter;
  ErrorCounter errors{filter};

  Influence() { filter->SetInputConnection(curves->GetOutputPort()); }
};

vtkSmartPointer<vtkStructuredGrid> faceOf(vtkPolyData* curves) {
  vtkNew<vtkPDEFaceFilter> face;
  face->SetInputData(curves);
  face->SetScheme("tangent");
  face->SetSmoothing(0.7);
  face->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  face->Update();
  return face->GetOutput();
}

}  // namespace

TEST(PDEInfluenceFilter, IsTheDifferenceOfTwoFaces) {
  Influence influence;
  influence.filter->SetScheme("tangent");
  influence.filter->SetSmoothing(0.7);
  influence.filter->SetCurve("C14");
  influence.filter->SetPoint(19);
  influence.filter->SetDirection(0.0, 3.0, 4.0);
  influence.filter->Update();
  EXPECT_EQ(influence.errors.count(), 0);
  vtkNew<vtkPolyData> moved;
  moved->DeepCopy(influence.curves->GetOutput());
  double p[3], q[3];
  moved->GetPoint(13 * 40 + 19, p);
  moved->GetPoints()->SetPoint(13 * 40 + 19, p[0], p[1] + 0.06, p[2] + 0.08);
  const auto before = faceOf(influence.curves->GetOutput()), after = faceOf(moved);
  vtkDataArray* array = influence.filter->GetOutput()->GetPointData()->GetArray("Influence");
  ASSERT_NE(array, nullptr);
  ASSERT_EQ(array->GetNumberOfTuples(), before->GetNumberOfPoints());
  const bool single = moved->GetPoints()->GetDataType() == VTK_FLOAT;
  for (vtkIdType i = 0; i < before->GetNumberOfPoints(); ++i) {
    before->GetPoint(i, p);
    after->GetPoint(i, q);
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(q[c] - p[c], 0.1 * array->GetTuple3(i)[c], single ? 1e-4 : 1e-10);
    influence.filter->GetOutput()->GetPoint(i, q);
    for (int c = 0; c < 3; ++c) ASSERT_EQ(q[c], p[c]);
  }
}

TEST(PDEInfluenceFilter, GivesAProfileAndItsHalfWidths) {
  Influence influence;
  EXPECT_TRUE(std::isnan(influence.filter->GetHalfWidthAbove()));
  influence.filter->Update();
  vtkTable* profile = influence.filter->GetProfile();
  ASSERT_EQ(profile->GetNumberOfRows(), 56);
  EXPECT_EQ(profile->GetValueByName(0, "curve").ToDouble(), 1.0);
  EXPECT_EQ(profile->GetValueByName(55, "curve").ToDouble(), 28.0);
  EXPECT_NEAR(profile->GetValueByName(18, "curve").ToDouble(), 10.0, 1e-12);
  EXPECT_NEAR(profile->GetValueByName(18, "influence_max").ToDouble(), 1.0, 1e-12);
  EXPECT_GT(influence.filter->GetHalfWidthAbove(), 0.3);
  EXPECT_LT(influence.filter->GetHalfWidthAbove(), 1.0);
  EXPECT_GT(influence.filter->GetHalfWidthBelowInRows(), influence.filter->GetHalfWidthBelow());
}

TEST(PDEInfluenceFilter, RefusesWhatDoesNotExist) {
  const auto refused = [](auto change, const char* word) {
    Influence influence;
    change(*influence.filter);
    influence.filter->Update();
    EXPECT_NE(influence.errors.first().find(word), std::string::npos) << influence.errors.first();
    EXPECT_EQ(influence.filter->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(influence.filter->GetProfile()->GetNumberOfRows(), 0);
  };
  refused([](auto& f) { f.SetCurve("C29"); }, "C1 .. C22");
  refused([](auto& f) { f.SetPoint(40); }, "0 .. 39");
  refused([](auto& f) { f.SetPoint(-2); }, "0 .. 39");
  refused([](auto& f) { f.SetDirection(0.0, 0.0, 0.0); }, "direction");
  refused([](auto& f) { f.SetSmoothing(-1.0); }, "0 < a");
  refused([](auto& f) { f.SetResolution(3, 3); }, "3x3");
  refused([](auto& f) { f.SetResolution(20000, 20000); }, "too fine");
}

TEST(PDEInfluenceFilter, PiecesEqualTheWholeAndTheFirstHasItsProfile) {
  Influence whole;
  whole.filter->Update();
  vtkDataArray* all = whole.filter->GetOutput()->GetPointData()->GetArray("Influence");
  for (int piece = 0; piece < 3; ++piece) {
    Influence part;
    part.filter->UpdatePiece(piece, 3, 0);
    vtkStructuredGrid* grid = part.filter->GetOutput();
    int extent[6];
    grid->GetExtent(extent);
    ASSERT_GT(grid->GetNumberOfPoints(), 0);
    ASSERT_LT(grid->GetNumberOfPoints(), 56 * 41);
    vtkDataArray* some = grid->GetPointData()->GetArray("Influence");
    ASSERT_EQ(some->GetNumberOfTuples(), grid->GetNumberOfPoints());
    vtkIdType i = 0;
    for (int row = extent[2]; row <= extent[3]; ++row)
      for (int column = extent[0]; column <= extent[1]; ++column, ++i)
        for (int c = 0; c < 3; ++c)
          ASSERT_EQ(some->GetTuple3(i)[c], all->GetTuple3(row * 41 + column)[c]) << row << " " << column;
    EXPECT_EQ(part.filter->GetProfile()->GetNumberOfRows(), piece == 0 ? 56 : 0);
    EXPECT_EQ(part.filter->GetHalfWidthAbove(), whole.filter->GetHalfWidthAbove());
  }
}

TEST(PDEInfluenceFilter, AnAbortedUpdateLeavesNoHalfOutput) {
  Influence influence;
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback(
      [](vtkObject* caller, unsigned long, void*, void*) { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  influence.filter->AddObserver(vtkCommand::ProgressEvent, abort);
  influence.filter->Update();
  EXPECT_EQ(influence.errors.count(), 0);
  EXPECT_EQ(influence.filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(influence.filter->GetProfile()->GetNumberOfRows(), 0);
  EXPECT_TRUE(std::isnan(influence.filter->GetHalfWidthAbove()));
}
