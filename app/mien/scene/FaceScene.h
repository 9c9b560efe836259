#pragma once

#include "SurfaceScene.h"

namespace mien {

class FacePipeline;

/// The texture of the pipeline's face, or nullptr when its state has none. Throws a FileFailure when it cannot be made.
vtkSmartPointer<vtkImageData> faceTexture(FacePipeline& pipeline);

/// A face of a pipeline, with its photograph and its boundary curves.
class FaceScene : public SurfaceScene {
 public:
  /// The pipeline must be up to date and outlive the scene. Throws a ValueFailure when the array to colour by is
  /// not there, a FileFailure when the texture cannot be made.
  FaceScene(FacePipeline& pipeline, const SceneStyle& style) : FaceScene(pipeline, style, faceTexture(pipeline)) {}

  /// @param texture  of faceTexture(), which many scenes of one face can share
  FaceScene(FacePipeline& pipeline, const SceneStyle& style, const vtkSmartPointer<vtkImageData>& texture);
  ~FaceScene();

  /// Draws the pipeline's present surface: unsigned char, 4 components, of the size asked for.
  vtkSmartPointer<vtkImageData> render();

 private:
  bool showsMouth() const;
  void addMouth();
  void addTexture(vtkImageData* image);
  void addCurves();
  void updateCurves();

  FacePipeline& pipeline_;
  vtkNew<vtkPolyDataMapper> curveMapper_;
  vtkNew<vtkActor> curves_;
  vtkNew<vtkPolyDataMapper> mouthMapper_;
};

/// A copy of the neutral face's surface; the pipeline's state stays as it was.
vtkSmartPointer<vtkPolyData> neutralSurface(FacePipeline& pipeline);

}  // namespace mien
