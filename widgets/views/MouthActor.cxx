#include "MouthActor.h"

#include <vtkActor.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>

#include "MouthInside.h"
#include "MouthSack.h"

namespace mien {

namespace {

constexpr double wholeGap = 2.5;  // mm between lips from which the inside has its own colour alone

}  // namespace

MouthActor::MouthActor(vtkRenderer* renderer) : inside_(QColor::fromRgbF(mouthColor[0], mouthColor[1], mouthColor[2])) {
  mapper_->SetInputData(mouthSack(nullptr));
  mapper_->ScalarVisibilityOff();
  actor_->SetMapper(mapper_);
  actor_->GetProperty()->LightingOff();
  dress();
  renderer->AddActor(actor_);
}

void MouthActor::follow(vtkPolyData* mouth) {
  mapper_->SetInputData(mouth);
  dress();
}

double MouthActor::shareOf(double gap) {
  return std::clamp((gap - MouthInside::leastGap) / (wholeGap - MouthInside::leastGap), 0.0, 1.0);
}

void MouthActor::setColor(const QColor& color) {
  inside_ = color;
  dress();
}

void MouthActor::fadeFrom(const QColor& lips) {
  fades_ = true;
  lips_ = lips;
  dress();
}

void MouthActor::dress() {
  vtkDataArray* gap = mapper_->GetInput()->GetFieldData()->GetArray("Gap");
  const bool isKnown = fades_ && gap && gap->GetNumberOfTuples() > 0;
  const double share = isKnown ? shareOf(gap->GetComponent(0, 0)) : 1.0, rest = lips_.isValid() ? 1.0 - share : 0.0;
  const QColor from = lips_.isValid() ? lips_ : inside_;
  actor_->GetProperty()->SetColor(inside_.redF() + rest * (from.redF() - inside_.redF()),
                                  inside_.greenF() + rest * (from.greenF() - inside_.greenF()),
                                  inside_.blueF() + rest * (from.blueF() - inside_.blueF()));
  actor_->GetProperty()->SetOpacity(lips_.isValid() ? 1.0 : share);
}

void MouthActor::setBehind(double units) {
  mapper_->SetResolveCoincidentTopologyToPolygonOffset();
  mapper_->SetRelativeCoincidentTopologyPolygonOffsetParameters(2.0, units);
}

void MouthActor::setVisible(bool visible) {
  actor_->SetVisibility(visible);
}

}  // namespace mien
