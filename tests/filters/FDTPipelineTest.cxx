/// What every filter of the deformation tables owes the pipeline: whole answers for pieces, nothing from nothing, no
/// half output.
#include <gtest/gtest.h>

#include "MarkerFaces.h"
#include "NamedTables.h"
#include "PipelineErrors.h"
#include "TemporaryFolder.h"
#include "TextFile.h"
#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkFDTDeformationFilter.h"
#include "vtkFDTFitFilter.h"
#include "vtkFacialRegionFilter.h"
#include "vtkFieldData.h"
#include "vtkPupilNormalizeFilter.h"
#include "vtkStructuredGrid.h"

namespace {

/// All three filters that keep the data's kind, with a table where one is needed.
std::vector<vtkSmartPointer<vtkPupilAlgorithm>> pointFilters() {
  auto deformation = vtkSmartPointer<vtkFDTDeformationFilter>::New();
  deformation->SetTableData(tableOf(*mien::namedTable("joy")));
  return {vtkSmartPointer<vtkPupilNormalizeFilter>::New(), vtkSmartPointer<vtkFacialRegionFilter>::New(), deformation};
}

void abortAtProgress(vtkObject* caller, unsigned long, void*, void*) {
  vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
}

}  // namespace

TEST(FDTPipeline, PartsOfAGridAreThePartsOfTheWhole) {
  const auto wholes = pointFilters(), parts = pointFilters();
  for (std::size_t i = 0; i < wholes.size(); ++i) {
    Face face;
    const std::string name = wholes[i]->GetClassName();
    wholes[i]->SetInputConnection(face.grid->GetOutputPort());
    wholes[i]->Update();
    auto* whole = vtkPointSet::SafeDownCast(wholes[i]->GetOutputDataObject(0));
    ASSERT_EQ(whole->GetNumberOfPoints(), 83 * 81) << name;
    int part[6] = {10, 40, 30, 60, 0, 0}, extent[6];
    parts[i]->SetInputConnection(face.grid->GetOutputPort());
    parts[i]->UpdateExtent(part);
    auto* grid = vtkStructuredGrid::SafeDownCast(parts[i]->GetOutputDataObject(0));
    grid->GetExtent(extent);
    ASSERT_EQ(std::vector<int>(extent, extent + 6), std::vector<int>(part, part + 6)) << name;
    for (int row = 30; row <= 60; ++row)
      for (int column = 10; column <= 40; ++column)
        for (int k = 0; k < 3; ++k)
          ASSERT_EQ(grid->GetPoint((row - 30) * 31 + column - 10)[k], whole->GetPoint(row * 81 + column)[k]) << name;
    const auto patch = [](vtkPointSet* data, vtkIdType cell) {
      return data->GetCellData()->GetArray("PatchId")->GetTuple1(cell);
    };
    ASSERT_EQ(grid->GetCellData()->GetArray("PatchId")->GetNumberOfTuples(), 30 * 30) << name;
    for (int row = 30; row < 60; ++row)
      ASSERT_EQ(patch(grid, (row - 30) * 30), patch(whole, row * 80 + 10)) << name << " " << row;
  }
}

TEST(FDTPipeline, PiecesOfMarkersMakeUpTheWholeOnce) {
  for (const auto& filter : pointFilters()) {
    filter->SetInputData(markers(nullptr));
    filter->Update();
    const vtkIdType whole = vtkPointSet::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints();
    EXPECT_GT(whole, 500);
    vtkIdType sum = 0;
    for (int piece = 0; piece < 3; ++piece) {
      filter->UpdatePiece(piece, 3, 0);
      sum += vtkPointSet::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints();
    }
    EXPECT_EQ(sum, whole) << filter->GetClassName();
  }
}

TEST(FDTPipeline, NothingGivesNothing) {
  for (const auto& filter : pointFilters()) {
    mien::PipelineErrors errors;
    errors.observe(filter);
    filter->SetInputData(vtkSmartPointer<vtkPolyData>::New());
    filter->Update();
    EXPECT_EQ(errors.first(), "") << filter->GetClassName();
    EXPECT_EQ(vtkPointSet::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints(), 0);
  }
}

TEST(FDTPipeline, AnAbortedUpdateLeavesNoHalfOutput) {
  for (const auto& filter : pointFilters()) {
    vtkNew<vtkCallbackCommand> abort;
    abort->SetCallback(abortAtProgress);
    filter->AddObserver(vtkCommand::ProgressEvent, abort);
    filter->SetInputData(markers(nullptr));
    filter->Update();
    EXPECT_EQ(vtkPointSet::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints(), 0)
        << filter->GetClassName();
  }
}

TEST(FDTPipeline, AnAbortAtAnyReportLeavesNoHalfOutput) {
  // Each filter in turn is stopped at its first, second, third .. report.
  for (std::size_t which = 0; which < pointFilters().size(); ++which)
    for (int report = 1; report <= 4; ++report) {
      const auto filter = pointFilters()[which];
      int left = report;
      vtkNew<vtkCallbackCommand> abort;
      abort->SetClientData(&left);
      abort->SetCallback([](vtkObject* caller, unsigned long, void* count, void* done) {
        if (*static_cast<double*>(done) < 1.0 && --*static_cast<int*>(count) <= 0)
          vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
      });
      filter->AddObserver(vtkCommand::ProgressEvent, abort);
      mien::PipelineErrors errors;
      errors.observe(filter);
      filter->SetInputData(markers(nullptr));
      filter->Update();
      EXPECT_EQ(errors.first(), "") << filter->GetClassName();
      if (left > 0) break;  // it reported less often
      EXPECT_EQ(vtkPointSet::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints(), 0)
          << filter->GetClassName() << " at report " << report;
    }
}

TEST(FDTPipeline, AnAbortedFitLeavesNoTable) {
  for (int report = 1; report <= 5; ++report) {
    int left = report;
    vtkNew<vtkCallbackCommand> abort;
    abort->SetClientData(&left);
    abort->SetCallback([](vtkObject* caller, unsigned long, void* count, void*) {
      if (--*static_cast<int*>(count) <= 0) vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
    });
    vtkNew<vtkFDTFitFilter> fit;
    fit->AddObserver(vtkCommand::ProgressEvent, abort);
    fit->SetInputData(markers(nullptr));
    fit->SetExpressionData(markers(nullptr));
    fit->Update();
    ASSERT_LE(left, 0) << "it reports " << report << " times at least";
    EXPECT_EQ(fit->GetOutput()->GetNumberOfRows(), 0) << report;
  }
}

TEST(FDTPipeline, ArraysThatDoNotFitThePointsAreRefused) {
  for (const auto& filter : pointFilters()) {
    mien::PipelineErrors errors;
    errors.observe(filter);
    auto data = markers(nullptr);
    auto* names = vtkStringArray::SafeDownCast(data->GetPointData()->GetAbstractArray("marker"));
    vtkNew<vtkStringArray> pairs, many;
    for (vtkStringArray* wrong : {pairs.Get(), many.Get()}) wrong->SetName("marker");
    pairs->SetNumberOfComponents(2);
    for (vtkIdType i = 0; i < 2 * names->GetNumberOfValues(); ++i) pairs->InsertNextValue("landmark62");
    for (vtkIdType i = 0; i < names->GetNumberOfValues() + 5; ++i) many->InsertNextValue("landmark62");
    many->SetValue(names->GetNumberOfValues() + 1, "pupil_left");
    data->GetPointData()->AddArray(pairs);
    filter->SetInputData(data);
    filter->Update();
    EXPECT_NE(errors.first().find("marker has 2 components"), std::string::npos) << errors.first();
    errors.clear();
    data->GetPointData()->AddArray(many);
    data->Modified();
    filter->Update();
    EXPECT_NE(errors.first().find("the point array marker has "), std::string::npos) << errors.first();
  }
}

TEST(FDTPipeline, BrokenInputIsRefusedAndNamed) {
  for (const auto& filter : pointFilters()) {
    mien::PipelineErrors errors;
    errors.observe(filter);
    auto data = markers(nullptr);
    data->GetPoints()->SetPoint(17, 0.0, std::nan(""), 0.0);
    filter->SetInputData(data);
    filter->Update();
    EXPECT_NE(errors.first().find("point 17"), std::string::npos) << filter->GetClassName() << ": " << errors.first();
    errors.clear();
    filter->SetLeftPupil(1.0, 2.0, std::nan(""));
    filter->Update();
    EXPECT_NE(errors.first().find("not finite"), std::string::npos) << errors.first();
    EXPECT_EQ(vtkPointSet::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints(), 0)
        << filter->GetClassName();
  }
}

TEST(FDTPipeline, ReadsARegionMapOfOnesOwn) {
  const TemporaryFolder folder;
  const std::string file = folder.file("regions.json");
  std::string text = readTextFile(std::string(MIEN_DATA_DIR) + "/deformation/regions.json");
  const std::string chin = "\"name\": \"chin\"";
  text.replace(text.find(chin), chin.size(), "\"name\": \"beard\"");
  writeTextFile(file, text);
  vtkNew<vtkFacialRegionFilter> filter;
  mien::PipelineErrors errors;
  errors.observe(filter);
  filter->SetInputData(markers(nullptr));
  filter->SetRegionFileName(file);
  filter->Update();
  auto* names = vtkStringArray::SafeDownCast(filter->GetOutput()->GetFieldData()->GetAbstractArray("RegionName"));
  ASSERT_TRUE(names);
  EXPECT_EQ(names->GetValue(15), "beard");
  writeTextFile(file, "{");
  filter->SetRegionFileName(file + "x");
  filter->Update();
  EXPECT_NE(errors.first().find("cannot be opened"), std::string::npos) << errors.first();
  errors.clear();
  filter->SetRegionFileName(file);
  filter->Update();
  EXPECT_NE(errors.first().find(file + ":1: region map"), std::string::npos) << errors.first();
}
