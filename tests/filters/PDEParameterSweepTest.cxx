#include <gtest/gtest.h>

#include <cmath>

#include "ErrorCounter.h"
#include "ReferenceData.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkPDEFaceFilter.h"
#include "vtkPDEParameterSweep.h"
#include "vtkPLYReader.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkStructuredGrid.h"
#include "vtkSurfaceDistanceFilter.h"
#include "vtkTable.h"
#include "vtkVariant.h"

namespace {

struct Sweep {
  vtkNew<vtkBoundaryCurveReader> curves;
  vtkNew<vtkPDEParameterSweep> filter;
  ErrorCounter errors{filter};

  Sweep() {
    filter->SetInputConnection(curves->GetOutputPort());
    filter->SetResolution(29, 40);
    filter->SetSmoothingRange("1,3,100");
  }
  double value(int row, const char* column) { return filter->GetOutput()->GetValueByName(row, column).ToDouble(); }
};

}  // namespace

TEST(PDEParameterSweep, GivesTheDocumentedTable) {
  Sweep sweep;
  sweep.filter->AddAllSchemes();
  sweep.filter->Update();
  EXPECT_EQ(sweep.errors.count(), 0);
  vtkTable* table = sweep.filter->GetOutput();
  EXPECT_EQ(table->GetNumberOfRows(), 18);
  const std::vector<std::string> columns = {
      "scheme",    "a",          "area_mm2",     "rms_departure_mm",      "max_departure_mm",  "curve_miss_rms_mm",
      "lebesgue",  "g1_max_deg", "folded_cells", "folded_cells_on_seams", "turned_area_share", "willmore_energy",
      "box_ratio", "reason"};
  ASSERT_EQ(table->GetNumberOfColumns(), static_cast<vtkIdType>(columns.size()));
  for (size_t i = 0; i < columns.size(); ++i) EXPECT_EQ(table->GetColumnName(i), columns[i]);
  EXPECT_EQ(table->GetValueByName(0, "scheme").ToString(), "four-curve");
  EXPECT_TRUE(std::isnan(sweep.value(2, "area_mm2")));
  EXPECT_NE(table->GetValueByName(2, "reason").ToString().find("250"), std::string::npos);
  EXPECT_EQ(table->GetValueByName(17, "reason").ToString(), "");
}

TEST(PDEParameterSweep, SaysWhereSchemesBreakDown) {
  Sweep sweep;
  sweep.filter->SetResolution(112, 80);
  sweep.filter->SetSmoothingRange("0.5:8:9log");
  sweep.filter->AddAllSchemes();
  sweep.filter->Update();
  const auto breakdown = [&](const char* scheme) { return sweep.filter->GetBreakdown(scheme); };
  EXPECT_LT(breakdown("four-curve"), breakdown("tangent"));
  EXPECT_LT(breakdown("tangent"), breakdown("spline"));
  EXPECT_LE(breakdown("spline"), breakdown("sixth-order"));
  EXPECT_NE(sweep.filter->GetBreakdownReason("four-curve"), "");
  sweep.filter->ClearSchemes();
  sweep.filter->SetSmoothingRange("0.5,1");
  sweep.filter->Update();
  EXPECT_TRUE(std::isnan(breakdown("spline")));
  EXPECT_EQ(sweep.filter->GetBreakdownReason("spline"), "");
}

TEST(PDEParameterSweep, BreakdownsDependOnNoGridAndNoList) {
  Sweep coarse, fine;
  coarse.filter->SetResolution(56, 40);
  coarse.filter->SetSmoothingRange("0.1:10:5log");
  fine.filter->SetResolution(112, 80);
  fine.filter->SetSmoothingRange("0.2:10:14log");
  for (Sweep* const sweep : {&coarse, &fine}) {
    sweep->filter->AddAllSchemes();
    sweep->filter->Update();
  }
  for (const char* const scheme : {"four-curve", "tangent", "curvature", "spline"})
    EXPECT_NEAR(coarse.filter->GetBreakdown(scheme) / fine.filter->GetBreakdown(scheme), 1.0, 0.02) << scheme;
}

TEST(PDEParameterSweep, MeasuresDistancesWhenThereIsAReference) {
  Sweep sweep;
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(10.0);
  sweep.filter->SetReferenceConnection(sphere->GetOutputPort());
  sweep.filter->Update();
  EXPECT_GT(sweep.value(0, "distance_rms_mm"), 50.0);
  EXPECT_LT(sweep.value(0, "distance_rms_mm"), 250.0);
  sweep.filter->SetReferenceConnection(nullptr);
  sweep.filter->Update();
  EXPECT_EQ(sweep.filter->GetOutput()->GetColumnByName("distance_rms_mm"), nullptr);
}

TEST(PDEParameterSweep, ThreadsChangeNothing) {
  Sweep one, three;
  one.filter->SetNumberOfThreads(1);
  three.filter->SetNumberOfThreads(3);
  for (Sweep* sweep : {&one, &three}) {
    vtkNew<vtkSphereSource> sphere;
    sweep->filter->SetReferenceConnection(sphere->GetOutputPort());
    sweep->filter->Update();
  }
  for (vtkIdType row = 0; row < 3; ++row)
    for (vtkIdType column = 1; column + 1 < one.filter->GetOutput()->GetNumberOfColumns(); ++column)
      EXPECT_EQ(one.filter->GetOutput()->GetValue(row, column).ToDouble(),
                three.filter->GetOutput()->GetValue(row, column).ToDouble());
}

TEST(PDEParameterSweep, AnAbortedSweepLeavesNothingAndRunsAgain) {
  Sweep sweep;
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*) {
    auto* filter = static_cast<vtkAlgorithm*>(caller);
    if (filter->GetProgress() > 0.3) filter->SetAbortExecute(1);
  });
  const auto observer = sweep.filter->AddObserver(vtkCommand::ProgressEvent, abort);
  sweep.filter->Update();
  EXPECT_EQ(sweep.filter->GetOutput()->GetNumberOfRows(), 0);
  EXPECT_TRUE(std::isnan(sweep.filter->GetBreakdown("spline")));
  sweep.filter->RemoveObserver(observer);
  sweep.filter->SetAbortExecute(0);
  sweep.filter->Modified();
  sweep.filter->Update();
  EXPECT_EQ(sweep.filter->GetOutput()->GetNumberOfRows(), 3);
}

TEST(PDEParameterSweep, ItsOwnSchemeAndSmoothingDoNotMatterBesideLists) {
  Sweep sweep;
  sweep.filter->AddScheme("spline");
  sweep.filter->SetScheme("four-curve");
  sweep.filter->SetSmoothing(900.0);  // which four-curve refuses
  sweep.filter->Update();
  EXPECT_EQ(sweep.errors.count(), 0) << sweep.errors.first();
  EXPECT_EQ(sweep.filter->GetOutput()->GetNumberOfRows(), 3);
}

TEST(PDEParameterSweep, RefusesWhatItCannotSweep) {
  const auto refused = [](auto change, const char* word) {
    Sweep sweep;
    change(*sweep.filter);
    sweep.filter->Update();
    EXPECT_NE(sweep.errors.first().find(word), std::string::npos) << sweep.errors.first();
    return sweep.filter->GetOutput()->GetNumberOfRows();
  };
  EXPECT_EQ(refused([](auto& f) { f.AddScheme("five"); }, "no scheme 'five'"), 0);
  EXPECT_EQ(refused([](auto& f) { f.SetSmoothingValues({1.0, -2.0}); }, "0 < a <= 1000"), 0);
  EXPECT_EQ(refused([](auto& f) { f.SetSmoothingValues({}); }, "at least one"), 0);
  EXPECT_EQ(refused([](auto& f) { f.SetResolution(5, 5); }, "5x5"), 0);
  EXPECT_EQ(refused([](auto& f) { f.SetReferenceData(vtkSmartPointer<vtkPolyData>::New()); }, "no polygons"), 0);
  EXPECT_GT(refused([](auto& f) { f.SetSmoothingRange("1:2"); }, "'1:2'"), 0);  // keeps its values
}

TEST(PDEParameterSweep, SplineOfTheGenericFaceDoesNotFoldAndFourCurveFoldsAtItsSeams) {
  Sweep sweep;
  sweep.filter->SetResolution(224, 160);
  sweep.filter->SetSmoothingValues({1.0});
  sweep.filter->AddScheme("four-curve");
  sweep.filter->AddScheme("spline");
  sweep.filter->Update();
  EXPECT_GT(sweep.value(0, "folded_cells"), 100.0);
  EXPECT_GT(sweep.value(0, "folded_cells_on_seams"), 0.5 * sweep.value(0, "folded_cells"));
  EXPECT_LE(sweep.value(1, "folded_cells"), 0.5 * sweep.value(0, "folded_cells"));
  EXPECT_EQ(sweep.value(1, "folded_cells_on_seams"), 0.0);
}

TEST(PDEParameterSweep, SplineStaysInsideTheBoxOfItsCurvesAtEveryA) {
  for (const int modes : {0, 5, 20}) {
    Sweep sweep;
    sweep.filter->SetNumberOfModes(modes);
    sweep.filter->SetResolution(110, 40);
    sweep.filter->SetSmoothingRange("0.01:1000:11log");
    sweep.filter->Update();
    ASSERT_EQ(sweep.filter->GetOutput()->GetNumberOfRows(), 11);
    for (int row = 0; row < 11; ++row) {
      EXPECT_LE(sweep.value(row, "box_ratio"), 1.03) << sweep.value(row, "a") << " " << modes;
      EXPECT_LE(sweep.value(row, "lebesgue"), 1.56);
    }
  }
}

TEST(PDEParameterSweep, DistanceToTheMeanHeadIsWhatTheDistanceFilterMeasures) {
  MIEN_REQUIRE_REFERENCE("heads/mean_neutral.ply");
  Sweep sweep;
  vtkNew<vtkPLYReader> head;
  head->SetFileName(referencePath("heads/mean_neutral.ply").c_str());
  sweep.filter->SetReferenceConnection(head->GetOutputPort());
  sweep.filter->SetResolution(224, 160);
  sweep.filter->SetSmoothingValues({1.0});
  sweep.filter->AddScheme("spline");
  sweep.filter->AddScheme("four-curve");
  sweep.filter->Update();
  vtkNew<vtkPDEFaceFilter> face;
  face->SetInputConnection(sweep.curves->GetOutputPort());
  face->SetResolution(224, 160);
  vtkNew<vtkSurfaceDistanceFilter> filter;
  filter->SetInputConnection(face->GetOutputPort());
  filter->SetReferenceConnection(head->GetOutputPort());
  filter->FrontalOnlyOn();
  for (int row = 0; row < 2; ++row) {
    face->SetScheme(sweep.filter->GetOutput()->GetValueByName(row, "scheme").ToString());
    filter->Update();
    EXPECT_NEAR(sweep.value(row, "distance_rms_mm") / filter->GetRMSDistance(), 1.0, 0.02)
        << row;  // integrals against facets
  }
}
