/// What each filter of the deformation tables does to markers and to the PDE face.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "BoundaryCurveData.h"
#include "MarkerFaces.h"
#include "NamedTables.h"
#include "PipelineErrors.h"
#include "vtkDoubleArray.h"
#include "vtkFDTDeformationFilter.h"
#include "vtkFDTFitFilter.h"
#include "vtkFacialRegionFilter.h"
#include "vtkFieldData.h"
#include "vtkPupilNormalizeFilter.h"
#include "vtkStructuredGrid.h"

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

TEST(PupilNormalizeFilter, ATurnedHeadIsTurnedThereToo) {
  auto data = markers(nullptr, 0.3);
  mien::HeadRotation turned;
  turned.rotation = Eigen::AngleAxisd(0.35, Eigen::Vector3d(0.2, 1.0, 0.1).normalized()).toRotationMatrix();
  turned.centre = {2.0, -60.0, 5.0};
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    const Eigen::Vector3d p(data->GetPoint(i));
    data->GetPoints()->SetPoint(i, (turned.rotation * (p - turned.centre) + turned.centre).eval().data());
  }
  mien::writeHeadRotation(turned, data->GetFieldData());
  vtkNew<vtkPupilNormalizeFilter> there, back;
  there->SetInputData(data);
  back->SetInputConnection(there->GetOutputPort());
  back->InverseOn();
  back->Update();
  mien::HeadRotation again;
  ASSERT_EQ(mien::readHeadRotation(back->GetOutput()->GetFieldData(), again), "");
  EXPECT_LT((again.rotation - turned.rotation).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((again.centre - turned.centre).norm(), 1e-10);
  // The regions of the face do not depend on whether it is normalised first.
  vtkNew<vtkFDTDeformationFilter> direct, normalised;
  for (vtkFDTDeformationFilter* filter : {direct.Get(), normalised.Get()})
    filter->SetTableData(tableOf(*mien::namedTable("joy")));
  direct->SetInputData(data);
  normalised->SetInputConnection(there->GetOutputPort());
  direct->Update();
  normalised->Update();
  vtkDataArray *a = direct->GetOutput()->GetPointData()->GetArray("Displacement"),
               *b = normalised->GetOutput()->GetPointData()->GetArray("Displacement");
  ASSERT_TRUE(a && b);
  // Normalised lengths are those of the turned face's pupils, a little nearer to each other.
  for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i) {
    const Eigen::Vector3d p(a->GetTuple3(i)[0], a->GetTuple3(i)[1], a->GetTuple3(i)[2]);
    const Eigen::Vector3d q(b->GetTuple3(i)[0], b->GetTuple3(i)[1], b->GetTuple3(i)[2]);
    const double unit = p.norm() / q.norm();
    if (p.norm() > 1.0) {
      ASSERT_NEAR(unit, 31.0 * std::cos(0.35), 1.5) << i;
    }
  }
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

TEST(FDTDeformationFilter, StrengthZeroIsTheInputBitForBit) {
  Face face;
  vtkNew<vtkFDTDeformationFilter> filter;
  filter->SetInputConnection(face.grid->GetOutputPort());
  filter->SetTableData(tableOf(*mien::namedTable("surprise")));
  filter->SetStrength(0.0);
  filter->Update();
  EXPECT_EQ(coordinates(filter->GetOutput()), coordinates(face.grid->GetOutput()));
  vtkDataArray *after = filter->GetOutput()->GetPointData()->GetNormals(),
               *before = face.grid->GetOutput()->GetPointData()->GetArray("Normals");
  ASSERT_TRUE(after && before);
  for (vtkIdType i = 0; i < before->GetNumberOfTuples(); ++i)
    for (int k = 0; k < 3; ++k) ASSERT_EQ(after->GetComponent(i, k), before->GetComponent(i, k)) << i;
  filter->SetStrength(1.0);
  filter->Update();
  after = filter->GetOutput()->GetPointData()->GetNormals();
  double turned = 0.0;
  for (vtkIdType i = 0; i < before->GetNumberOfTuples(); ++i)
    turned = std::max(turned, std::abs(after->GetComponent(i, 1) - before->GetComponent(i, 1)));
  EXPECT_GT(turned, 0.1) << "else they do not turn at all";
}

TEST(FDTDeformationFilter, ExchangedPupilsAreRefused) {
  Face face;
  face.grid->Update();
  vtkDataArray* pupils = face.grid->GetOutput()->GetFieldData()->GetArray("Pupils");
  ASSERT_TRUE(pupils);
  vtkNew<vtkFDTDeformationFilter> filter;
  mien::PipelineErrors errors;
  errors.observe(filter);
  filter->SetInputConnection(face.grid->GetOutputPort());
  filter->SetTableData(tableOf(*mien::namedTable("joy")));
  filter->SetLeftPupil(pupils->GetTuple3(0));
  filter->SetRightPupil(pupils->GetTuple3(1));
  filter->Update();
  EXPECT_EQ(errors.first(), "");
  const Eigen::Vector3d left(pupils->GetTuple3(0)), right(pupils->GetTuple3(1));
  filter->SetLeftPupil(right.x(), right.y(), right.z());
  filter->SetRightPupil(left.x(), left.y(), left.z());
  filter->Update();
  EXPECT_NE(errors.first().find("the nose lies above the eyes; exchange the pupils"), std::string::npos)
      << errors.first();
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

TEST(FDTDeformationFilter, PointsWithoutPolygonsKeepTheirNormals) {
  auto data = markers(nullptr);
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) normals->InsertNextTuple3(0.6, 0.0, 0.8);
  data->GetPointData()->SetNormals(normals);
  vtkNew<vtkFDTDeformationFilter> filter;
  filter->SetInputData(data);
  filter->SetTableData(tableOf(*mien::namedTable("joy")));
  filter->Update();
  vtkDataArray* kept = filter->GetOutput()->GetPointData()->GetNormals();
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->GetComponent(17, 0), 0.6);
}

TEST(FDTDeformationFilter, DerivativesOfTheSurfaceBeforeAreLeftOut) {
  auto data = markers(nullptr);
  for (const char* name : {"Su", "MeanCurvature", "Temperature"}) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfTuples(data->GetNumberOfPoints());
    array->Fill(1.0);
    data->GetPointData()->AddArray(array);
  }
  vtkNew<vtkFDTDeformationFilter> filter;
  filter->SetInputData(data);
  filter->SetTableData(tableOf(*mien::namedTable("joy")));
  filter->Update();
  vtkPointData* left = filter->GetOutput()->GetPointData();
  EXPECT_FALSE(left->HasArray("Su") || left->HasArray("MeanCurvature"));
  EXPECT_TRUE(left->HasArray("Temperature"));
}

TEST(FDTDeformationFilter, ThePDEFaceTearsAtItsSlitsAlone) {
  Face face;
  vtkNew<vtkFDTDeformationFilter> filter;
  filter->SetInputConnection(face.grid->GetOutputPort());
  for (const std::string& name : mien::tableNames()) {
    filter->SetTableData(tableOf(*mien::namedTable(name)));
    filter->Update();
    vtkStructuredGrid* grid = vtkStructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
    vtkDataArray* moves = grid->GetPointData()->GetArray("Displacement");
    double steepest = 0.0;
    int row = 0, column = 0;
    const auto compare = [&](int a, int b) {
      const Eigen::Vector3d p(face.grid->GetOutput()->GetPoint(a)), q(face.grid->GetOutput()->GetPoint(b));
      Eigen::Vector3d d, e;
      moves->GetTuple(a, d.data());
      moves->GetTuple(b, e.data());
      const double slope = (d - e).norm() / std::max((p - q).norm(), 0.5);
      if (slope > steepest) steepest = slope, row = a / 81, column = a % 81;
    };
    for (int r = 0; r < 83; ++r)
      for (int c = 0; c < 80; ++c) {
        compare(r * 81 + c, r * 81 + c + 1);
        // Rows 63 and 64 are the lips, C22 and C23.
        if (r + 1 < 83 && r != 63) compare(r * 81 + c, (r + 1) * 81 + c);
      }
    EXPECT_LE(steepest, 1.5) << name << " at row " << row << ", column " << column;
  }
}
