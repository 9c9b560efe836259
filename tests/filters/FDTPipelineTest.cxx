/// What every filter of the deformation tables owes the pipeline: whole answers for pieces, nothing from nothing, no
/// half output.
#include <gtest/gtest.h>

#include <cmath>

#include "DefaultRegions.h"
#include "FDTData.h"
#include "NamedTables.h"
#include "PipelineErrors.h"
#include "TemporaryFolder.h"
#include "TextFile.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFDTDeformationFilter.h"
#include "vtkFDTFitFilter.h"
#include "vtkFDTReader.h"
#include "vtkFacialRegionFilter.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPDEFaceFilter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPupilNormalizeFilter.h"
#include "vtkStringArray.h"
#include "vtkStructuredGrid.h"
#include "vtkTable.h"

namespace {

/// The generic PDE face.
struct Face {
  vtkNew<vtkBoundaryCurveReader> curves;
  vtkNew<vtkPDEFaceFilter> grid;

  Face() {
    grid->SetInputConnection(curves->GetOutputPort());
    grid->SetResolution(83, 80);
  }
};

/// Markers on a grid over a face whose pupils are 62 apart; `moved` bends them by a table.
vtkSmartPointer<vtkPolyData> markers(const mien::DeformationTable* table, double turn = 0.0) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkStringArray> names;
  names->SetName("marker");
  vtkNew<vtkIntArray> regions;
  regions->SetName("region");
  const mien::FacialRegions& map = mien::defaultRegions();
  const auto add = [&](const char* name, const Eigen::Vector2d& p, int region) {
    const double x = 31 * p.x() + 3, y = 31 * p.y() + 40;
    points->InsertNextPoint(std::cos(turn) * x - std::sin(turn) * y, std::sin(turn) * x + std::cos(turn) * y, 80.0);
    names->InsertNextValue(name);
    regions->InsertNextValue(region);
  };
  add("pupil_left", {1.0, 0.0}, 0);
  add("pupil_right", {-1.0, 0.0}, 0);
  for (double y = -3.9; y < 1.9; y += 0.2)
    for (double x = -1.9; x < 2.0; x += 0.2) {
      const Eigen::Vector2d p(x, y);
      const int region = map.nearest(p);
      add("skin", table ? table->maps[region - 1].apply(p) : p, region);
    }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->AddArray(names);
  data->GetPointData()->AddArray(regions);
  return data;
}

std::vector<double> coordinates(vtkPointSet* data) {
  std::vector<double> result;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    for (int k = 0; k < 3; ++k) result.push_back(data->GetPoint(i)[k]);
  return result;
}

vtkSmartPointer<vtkTable> tableOf(const mien::DeformationTable& table) {
  auto data = vtkSmartPointer<vtkTable>::New();
  mien::writeFDT(table, data);
  return data;
}

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
  EXPECT_NE(errors.first().find(file + ": region map"), std::string::npos) << errors.first();
}

TEST(PupilNormalizeFilter, ThereAndBackIsTheFace) {
  auto data = markers(nullptr, 0.3);
  vtkNew<vtkPupilNormalizeFilter> there, back;
  there->SetInputData(data);
  back->SetInputConnection(there->GetOutputPort());
  back->InverseOn();
  back->Update();
  const double* left = there->GetOutput()->GetPoint(0);
  EXPECT_NEAR(left[0], 1.0, 1e-12);
  EXPECT_NEAR(left[1], 0.0, 1e-12);
  const std::vector<double> before = coordinates(data), after = coordinates(back->GetOutput());
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(before[i], after[i], 1e-12);
}

TEST(FacialRegionFilter, TheLipsOfThePDEFaceAreToldApartByU) {
  Face face;
  vtkNew<vtkFacialRegionFilter> filter;
  filter->SetInputConnection(face.grid->GetOutputPort());
  filter->Update();
  vtkPointData* data = filter->GetOutput()->GetPointData();
  vtkDataArray *lips = data->GetArray("LipSide"), *region = data->GetArray("Region"),
               *weights = data->GetArray("RegionWeights");
  ASSERT_TRUE(lips && region && weights);
  const int upper = 63 * 81 + 40;  // row 63 of 83 is C22, column 40 of 80 the middle
  EXPECT_EQ(lips->GetComponent(upper, 0), 1.0);
  EXPECT_EQ(lips->GetComponent(upper + 81, 0), -1.0);
  EXPECT_EQ(region->GetComponent(upper, 0), 12);
  EXPECT_EQ(region->GetComponent(upper + 81, 0), 13);
  EXPECT_EQ(weights->GetComponent(upper, 12), 0.0);
  EXPECT_EQ(weights->GetComponent(upper + 81, 11), 0.0);
  EXPECT_EQ(lips->GetComponent(63 * 81, 0), 0.0) << "the back of the head";
  for (vtkIdType i = 0; i < weights->GetNumberOfTuples(); ++i) {
    double sum = 0.0;
    for (int k = 0; k < 16; ++k) sum += weights->GetComponent(i, k);
    ASSERT_NEAR(sum, 1.0, 1e-6);
  }
}

TEST(FDTFitFilter, ReturnsTheMapsThatMadeTheMovement) {
  mien::DeformationTable table = *mien::namedTable("surprise");
  vtkNew<vtkFDTFitFilter> fit;
  fit->SetInputData(markers(nullptr));
  fit->SetExpressionData(markers(&table, -0.2));
  fit->Update();
  mien::DeformationTable fitted;
  ASSERT_EQ(mien::readFDT(fit->GetOutput(), fitted), "");
  for (int i = 0; i < 16; ++i)
    EXPECT_LT((fitted.maps[i].coefficients - table.maps[i].coefficients).cwiseAbs().maxCoeff(), 1e-10) << i + 1;
  EXPECT_LT(fit->GetRMS(), 1e-13);
  EXPECT_EQ(fit->GetWarning(), "");
  EXPECT_TRUE(fit->GetOutput()->GetColumnByName("points") && fit->GetOutput()->GetColumnByName("rms"));
}

TEST(FDTFitFilter, NamesSparseRegionsAndRefusesThemWhenStrict) {
  auto data = markers(nullptr);
  vtkDataArray* regions = data->GetPointData()->GetArray("region");
  int kept = 0;
  for (vtkIdType i = 0; i < regions->GetNumberOfTuples(); ++i)
    if (regions->GetComponent(i, 0) == 9 && ++kept > 4) regions->SetComponent(i, 0, 8);
  vtkNew<vtkFDTFitFilter> fit;
  mien::PipelineErrors errors;
  errors.observe(fit);
  fit->SetInputData(data);
  fit->SetExpressionData(data);
  fit->Update();
  EXPECT_EQ(errors.first(), "");
  EXPECT_NE(fit->GetWarning().find("region 9 has fewer than 6"), std::string::npos) << fit->GetWarning();
  fit->StrictOn();
  fit->Update();
  EXPECT_NE(errors.first().find("region 9 has fewer than 6"), std::string::npos);
  EXPECT_EQ(fit->GetOutput()->GetNumberOfRows(), 0);
  errors.clear();
  fit->StrictOff();
  vtkNew<vtkPolyData> fewer;
  fit->SetExpressionData(fewer);
  fit->Update();
  EXPECT_NE(errors.first().find("and the expression 0"), std::string::npos) << errors.first();
}

TEST(FDTDeformationFilter, WeightsAreKeptWhileOnlyTablesChange) {
  Face face;
  vtkNew<vtkFDTDeformationFilter> filter, fresh;
  filter->SetInputConnection(face.grid->GetOutputPort());
  fresh->SetInputConnection(face.grid->GetOutputPort());
  filter->SetTableData(tableOf(*mien::namedTable("joy")));
  filter->Update();
  const std::vector<double> joy = coordinates(filter->GetOutput());
  filter->SetTableData(tableOf(*mien::namedTable("surprise")));
  filter->SetStrength(0.7);
  filter->Update();
  fresh->SetTableData(tableOf(*mien::namedTable("surprise")));
  fresh->SetStrength(0.7);
  fresh->Update();
  EXPECT_EQ(coordinates(filter->GetOutput()), coordinates(fresh->GetOutput()));
  EXPECT_NE(coordinates(filter->GetOutput()), joy);
  face.grid->SetResolution(56, 40);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 56 * 41);
  const auto time = filter->GetOutput()->GetMTime();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetMTime(), time);
}

TEST(FDTDeformationFilter, TheIdentityMovesNothingAndKeepsNormals) {
  Face face;
  vtkNew<vtkFDTDeformationFilter> filter;
  filter->SetInputConnection(face.grid->GetOutputPort());
  filter->SetTableData(tableOf(mien::DeformationTable()));
  filter->Update();
  EXPECT_EQ(coordinates(filter->GetOutput()), coordinates(face.grid->GetOutput()));
  vtkDataArray *after = filter->GetOutput()->GetPointData()->GetArray("Normals"),
               *before = face.grid->GetOutput()->GetPointData()->GetArray("Normals");
  ASSERT_TRUE(after && before);
  for (vtkIdType i = 0; i < before->GetNumberOfTuples(); ++i)
    for (int k = 0; k < 3; ++k) ASSERT_NEAR(after->GetComponent(i, k), before->GetComponent(i, k), 1e-6);
}

TEST(FDTDeformationFilter, TheMouthOfThePDEFaceOpensInSurprise) {
  Face face;
  vtkNew<vtkFDTDeformationFilter> filter;
  filter->SetInputConnection(face.grid->GetOutputPort());
  filter->SetTableData(tableOf(*mien::namedTable("surprise")));
  filter->Update();
  vtkDataArray* moves = filter->GetOutput()->GetPointData()->GetArray("Displacement");
  const int upper = 63 * 81 + 40;
  EXPECT_GT(moves->GetComponent(upper, 1) - moves->GetComponent(upper + 81, 1), 6.0);
  EXPECT_EQ(moves->GetComponent(63 * 81, 1), 0.0) << "the back of the head";
}
