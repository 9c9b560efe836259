// The generic face in joy through the filters and through the mathematics that they include: prints the points' number
// and the largest motion.
#include <iostream>

#include "FacePipeline.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkFAPAnimationFilter.h"
#include "vtkMotionVectorFilter.h"
#include "vtkNew.h"
#include "vtkPDEFaceFilter.h"
#include "vtkStructuredGrid.h"

int main() {
  vtkNew<vtkBoundaryCurveReader> curves;
  vtkNew<vtkFAPAnimationFilter> animation;
  vtkNew<vtkPDEFaceFilter> face, rest;
  vtkNew<vtkMotionVectorFilter> motion;
  animation->SetInputConnection(curves->GetOutputPort());
  animation->SetExpression("joy", 1.0);
  face->SetInputConnection(animation->GetOutputPort());
  rest->SetInputConnection(curves->GetOutputPort());
  motion->SetInputConnection(face->GetOutputPort());
  motion->SetNeutralConnection(rest->GetOutputPort());
  motion->Update();

  mien::FaceState state;
  state.expressions["joy"] = 1.0;
  mien::FacePipeline pipeline;
  pipeline.setState(state);
  if (!pipeline.update().empty() || pipeline.grid()->GetNumberOfPoints() != face->GetOutput()->GetNumberOfPoints())
    return 1;
  std::cout << face->GetOutput()->GetNumberOfPoints() << " " << motion->GetLargestMagnitude() << "\n";
}
