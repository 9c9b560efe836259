#pragma once

#include "SurfaceScene.h"

namespace mien {

class FacePipeline;

/// A face of a pipeline, with its photograph and its boundary curves.
class FaceScene : public SurfaceScene {
 public:
  /// The pipeline must be up to date and outlive the scene. Throws a ValueFailure when the array to colour by is
  /// not there, a FileFailure when the texture cannot be made.
  FaceScene(FacePipeline& pipeline, const SceneStyle& style);
  ~FaceScene();

  /// Draws the pipeline's present surface: unsigned char, 4 components, of the size asked for.
  vtkSmartPointer<vtkImageData> render();

 private:
  void addTexture();
  void addCurves();
  void updateCurves();

  FacePipeline& pipeline_;
  vtkNew<vtkPolyDataMapper> curveMapper_;
  vtkNew<vtkActor> curves_;
};

/// A copy of the neutral face's surface; the pipeline's state stays as it was.
vtkSmartPointer<vtkPolyData> neutralSurface(FacePipeline& pipeline);

}  // namespace mien
