#include "MouthActor.h"

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "MouthSack.h"

namespace mien {

MouthActor::MouthActor(vtkRenderer* renderer) {
  mapper_->SetInputData(mouthSack(nullptr));
  mapper_->ScalarVisibilityOff();
  actor_->SetMapper(mapper_);
  actor_->GetProperty()->LightingOff();
  actor_->GetProperty()->SetColor(mouthColor[0], mouthColor[1], mouthColor[2]);
  renderer->AddActor(actor_);
}

void MouthActor::follow(vtkPolyData* mouth) {
  mapper_->SetInputData(mouth);
}

vtkProperty* MouthActor::property() {
  return actor_->GetProperty();
}

void MouthActor::setBehind(double units) {
  mapper_->SetResolveCoincidentTopologyToPolygonOffset();
  mapper_->SetRelativeCoincidentTopologyPolygonOffsetParameters(2.0, units);
}

void MouthActor::setVisible(bool visible) {
  actor_->SetVisibility(visible);
}

}  // namespace mien
