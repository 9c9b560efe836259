#include <gtest/gtest.h>

#include <algorithm>

#include "BoundaryCurveData.h"
#include "RandomCurves.h"
#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkOrderedGeometryFilter.h"
#include "vtkPDEFaceFilter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkStructuredGrid.h"

// vtkGeometryFilter joins the cells of its threads as they end; large grids came in another order on every run.
TEST(OrderedGeometryFilter, CellsKeepTheOrderOfTheGrid) {
  vtkNew<vtkPolyData> curves;
  mien::writeFaceCurves(randomFace(), curves);
  vtkNew<vtkPDEFaceFilter> face;
  face->SetInputData(curves);
  face->SetResolution(448, 160);
  vtkNew<vtkOrderedGeometryFilter> surface;
  surface->SetInputConnection(face->GetOutputPort());
  for (int run = 0; run < 8; ++run) {
    surface->Modified();
    surface->Update();
    vtkPolyData* polygons = surface->GetOutput();
    vtkDataArray* patches = polygons->GetCellData()->GetArray("PatchId");
    ASSERT_NE(patches, nullptr);
    EXPECT_EQ(polygons->GetCellData()->GetNumberOfArrays(), face->GetOutput()->GetCellData()->GetNumberOfArrays());
    EXPECT_GT(polygons->GetNumberOfCells(), 440 * 160);
    vtkIdType last = -1, unordered = 0, wrong = 0;
    for (vtkIdType cell = 0; cell < polygons->GetNumberOfCells(); ++cell) {
      vtkIdType size = 0;
      const vtkIdType* points = nullptr;
      polygons->GetCellPoints(cell, size, points);
      const vtkIdType first = *std::min_element(points, points + size);
      const vtkIdType row = first / 161, column = first % 161;
      unordered += first <= last;
      wrong += patches->GetComponent(cell, 0) !=
               face->GetOutput()->GetCellData()->GetArray("PatchId")->GetComponent(row * 160 + column, 0);
      last = first;
    }
    EXPECT_EQ(unordered, 0);
    EXPECT_EQ(wrong, 0) << "cell data move with their cells";
  }
}

TEST(OrderedGeometryFilter, ReversedPolygonsOfAFaceLookAlongItsNormals) {
  vtkNew<vtkPolyData> curves;
  mien::writeFaceCurves(randomFace(), curves);
  vtkNew<vtkPDEFaceFilter> face;
  face->SetInputData(curves);
  vtkNew<vtkOrderedGeometryFilter> surface;
  surface->SetInputConnection(face->GetOutputPort());
  for (const bool reversed : {false, true}) {
    surface->SetReversed(reversed);
    surface->Update();
    vtkPolyData* polygons = surface->GetOutput();
    vtkDataArray* normals = polygons->GetPointData()->GetNormals();
    double along = 0.0;
    for (vtkIdType cell = 0; cell < polygons->GetNumberOfCells(); ++cell) {
      double normal[3];
      vtkCell* polygon = polygons->GetCell(cell);
      vtkPolygon::ComputeNormal(polygon->GetPoints(), normal);
      along += vtkMath::Dot(normal, normals->GetTuple3(polygon->GetPointId(0))) / polygons->GetNumberOfCells();
    }
    EXPECT_GT(reversed ? along : -along, 0.9);
  }
}
