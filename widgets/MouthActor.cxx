#include "MouthActor.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "BoundaryCurveData.h"
#include "MouthInside.h"

namespace mien {

namespace {

constexpr double dark[3] = {0.24, 0.11, 0.10};  // in both themes: a mouth has no light of its own

}  // namespace

MouthActor::MouthActor(vtkRenderer* renderer) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(sack_);
  mapper->ScalarVisibilityOff();
  actor_->SetMapper(mapper);
  actor_->GetProperty()->LightingOff();
  actor_->GetProperty()->SetColor(dark[0], dark[1], dark[2]);
  renderer->AddActor(actor_);
}

/// A face without features or lips has no mouth that could open.
void MouthActor::follow(vtkPolyData* curves) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  FaceCurves face;
  if (curves && readFaceCurves(curves, face).empty()) {
    const MouthInside inside(face);
    for (const Eigen::Vector3d& point : inside.points) points->InsertNextPoint(point.data());
    for (const std::array<int, 3>& corners : inside.triangles) {
      const vtkIdType ids[3] = {corners[0], corners[1], corners[2]};
      triangles->InsertNextCell(3, ids);
    }
  }
  sack_->SetPoints(points);
  sack_->SetPolys(triangles);
  sack_->Modified();
}

void MouthActor::setVisible(bool visible) {
  actor_->SetVisibility(visible);
}

}  // namespace mien
