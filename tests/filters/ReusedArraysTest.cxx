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
