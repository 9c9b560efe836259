#include <gtest/gtest.h>

#include <set>

#include "BoundaryCurveData.h"
#include "RandomCurves.h"
#include "ReusedArrays.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPDEFaceFilter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"

namespace {

/// The face with other lower lips and chin: half of its patches stay as they are.
mien::FaceCurves talking(int index) {
  mien::FaceCurves face = randomFace();
  const mien::FaceCurves other = randomFace(40, index);
  for (int c = 19; c < 24; ++c) face.curves.curve(c) = other.curves.curve(c);
  return face;
}

void expectEqual(vtkDataArray* shown, vtkDataArray* expected) {
  ASSERT_TRUE(shown && expected);
  ASSERT_EQ(shown->GetNumberOfValues(), expected->GetNumberOfValues());
  for (vtkIdType i = 0; i < shown->GetNumberOfTuples(); ++i)
    for (int k = 0; k < shown->GetNumberOfComponents(); ++k)
      ASSERT_EQ(shown->GetComponent(i, k), expected->GetComponent(i, k)) << shown->GetName() << " of point " << i;
}

void expectShows(vtkPDEFaceFilter* filter, const mien::FaceCurves& face) {
  vtkNew<vtkPolyData> curves;
  mien::writeFaceCurves(face, curves);
  vtkNew<vtkPDEFaceFilter> other;
  other->SetResolution(filter->GetNumberOfRows(), filter->GetNumberOfColumns());
  other->SetGenerateDerivatives(filter->GetGenerateDerivatives());
  other->SetGenerateCurvatures(filter->GetGenerateCurvatures());
  other->SetInputData(curves);
  other->Update();
  expectEqual(filter->GetOutput()->GetPoints()->GetData(), other->GetOutput()->GetPoints()->GetData());
  for (const char* name : {"Normals", "Su", "Sv", "MeanCurvature"})
    if (other->GetOutput()->GetPointData()->HasArray(name))
      expectEqual(filter->GetOutput()->GetPointData()->GetArray(name),
                  other->GetOutput()->GetPointData()->GetArray(name));
}

}  // namespace

// Patches without a change are not computed again; whatever happens between two updates, nobody sees that.
TEST(ReusedArrays, PatchesThatAreLeftAloneAreThoseThatWouldBeMade) {
  vtkNew<vtkPolyData> curves;
  vtkNew<vtkPDEFaceFilter> filter;
  filter->SetInputData(curves);
  vtkSmartPointer<vtkDataArray> held;
  for (int i = 0; i < 12; ++i) {
    if (i == 3) filter->GenerateDerivativesOn();
    if (i == 5) filter->GenerateCurvaturesOn();
    if (i == 6) filter->GenerateCurvaturesOff();
    if (i == 7) filter->GenerateDerivativesOff();
    if (i == 8) filter->SetResolution(83, 200);
    mien::writeFaceCurves(talking(i), curves);
    filter->Update();
    expectShows(filter, talking(i));
    if (i % 4 == 1) held = filter->GetOutput()->GetPoints()->GetData();
  }
}

TEST(ReusedArrays, WhatSomebodyWroteIntoAnOutputIsNotTakenForASurface) {
  vtkNew<vtkPolyData> curves;
  vtkNew<vtkPDEFaceFilter> filter;
  filter->SetInputData(curves);
  for (int i = 0; i < 3; ++i) {
    mien::writeFaceCurves(talking(i), curves);
    filter->Update();
    expectShows(filter, talking(i));
    vtkDataArray* const points = filter->GetOutput()->GetPoints()->GetData();
    points->Fill(7.0);
    points->Modified();
  }
}

TEST(ReusedArrays, ArraysThatSomebodyHoldsAreNotWrittenOver) {
  vtkNew<vtkPolyData> curves;
  mien::writeFaceCurves(randomFace(), curves);
  vtkNew<vtkPDEFaceFilter> filter;
  filter->SetInputData(curves);
  filter->Update();
  const vtkSmartPointer<vtkDataArray> held = filter->GetOutput()->GetPoints()->GetData();
  vtkNew<vtkFloatArray> copy;
  copy->DeepCopy(held);
  vtkNew<vtkStructuredGrid> shared;
  std::set<vtkDataArray*> used;
  for (int i = 1; i <= 6; ++i) {
    mien::writeFaceCurves(randomFace(40, i), curves);
    filter->Update();
    vtkDataArray* const normals = filter->GetOutput()->GetPointData()->GetNormals();
    EXPECT_NE(filter->GetOutput()->GetPoints()->GetData(), held.Get());
    EXPECT_NE(normals, shared->GetPointData()->GetNormals()) << "the grid of the last update shares it";
    shared->ShallowCopy(filter->GetOutput());
    used.insert(normals);
  }
  EXPECT_LE(used.size(), 3u) << "those that nobody holds are used again";
  ASSERT_EQ(held->GetNumberOfValues(), copy->GetNumberOfValues());
  for (vtkIdType i = 0; i < copy->GetNumberOfValues(); ++i)
    ASSERT_EQ(held->GetComponent(i / 3, i % 3), copy->GetValue(i));
}
