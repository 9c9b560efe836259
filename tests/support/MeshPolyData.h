#pragma once

#include "TriangleMesh.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

/// A mesh as filters take it, double precision.
inline void fillPolyData(const mien::TriangleMesh& mesh, vtkPolyData* data) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < mesh.vertices.rows(); ++i) points->InsertNextPoint(mesh.vertices.row(i).data());
  vtkNew<vtkCellArray> triangles;
  for (int t = 0; t < mesh.triangles.rows(); ++t)
    triangles->InsertNextCell({mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2)});
  data->SetPoints(points);
  data->SetPolys(triangles);
}
