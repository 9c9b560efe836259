#include "MouthSack.h"

#include "BoundaryCurveData.h"
#include "MouthInside.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace mien {

vtkSmartPointer<vtkPolyData> mouthSack(vtkPolyData* curves) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkDoubleArray> gap;
  gap->SetName("Gap");
  FaceCurves face;
  if (curves && readFaceCurves(curves, face).empty()) {
    const MouthInside inside(face);
    gap->InsertNextValue(inside.gap);
    for (const Eigen::Vector3d& point : inside.points) points->InsertNextPoint(point.data());
    for (const std::array<int, 3>& corners : inside.triangles) {
      const vtkIdType ids[3] = {corners[0], corners[1], corners[2]};
      triangles->InsertNextCell(3, ids);
    }
  }
  auto sack = vtkSmartPointer<vtkPolyData>::New();
  sack->SetPoints(points);
  sack->SetPolys(triangles);
  sack->GetFieldData()->AddArray(gap);
  return sack;
}

}  // namespace mien
