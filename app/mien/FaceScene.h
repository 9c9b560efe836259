#pragma once

#include "SceneStyle.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

class vtkActor;
class vtkImageData;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkRenderWindow;
class vtkRenderer;
class vtkReverseSense;
class vtkScalarBarActor;

namespace mien {

class FacePipeline;
struct FaceFrame;

/// The texture of the pipeline's face, or nullptr when its state has none. Throws a FileFailure when it cannot be made.
vtkSmartPointer<vtkImageData> faceTexture(FacePipeline& pipeline);

/// A face under three lights, drawn without a window. There must be a display; see VirtualDisplay.
class FaceScene {
 public:
  /// The pipeline must be up to date and outlive the scene. Throws a ValueFailure when the array to colour by is
  /// not there, a FileFailure when the texture cannot be made.
  FaceScene(FacePipeline& pipeline, const SceneStyle& style) : FaceScene(pipeline, style, faceTexture(pipeline)) {}

  /// @param texture  of faceTexture(), which many scenes of one face can share
  FaceScene(FacePipeline& pipeline, const SceneStyle& style, const vtkSmartPointer<vtkImageData>& texture);
  ~FaceScene();

  /// Frames these points, in place of the surface as it was when the scene was made.
  void placeCamera(vtkPolyData* visible);

  /// Frames the neutral face, or both when these points are not all seen then.
  void placeCamera(vtkPolyData* neutral, vtkPolyData* visible);

  /// Draws the pipeline's present surface: unsigned char, 4 components, of the size asked for.
  vtkSmartPointer<vtkImageData> render();

 private:
  FaceFrame frame() const;
  void addSurface();
  void addMouth();
  void addTexture(vtkImageData* image);
  void addCurves();
  void updateCurves();
  void addLights();
  void addColors();

  FacePipeline& pipeline_;
  SceneStyle style_;
  int factor_;  ///< pixels computed per pixel shown, along each side
  vtkNew<vtkReverseSense> outwards_;
  vtkNew<vtkPolyDataMapper> surfaceMapper_;
  vtkNew<vtkActor> surface_;
  vtkNew<vtkPolyDataMapper> curveMapper_;
  vtkNew<vtkActor> curves_;
  vtkNew<vtkPolyDataMapper> mouthMapper_;
  vtkNew<vtkScalarBarActor> bar_;
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkRenderWindow> window_;
};

/// A copy of the neutral face's surface; the pipeline's state stays as it was.
vtkSmartPointer<vtkPolyData> neutralSurface(FacePipeline& pipeline);

}  // namespace mien
