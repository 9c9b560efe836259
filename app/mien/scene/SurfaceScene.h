#pragma once

#include "SceneStyle.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

class vtkActor;
class vtkAlgorithm;
class vtkImageData;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkRenderWindow;
class vtkRenderer;
class vtkScalarBarActor;

namespace mien {

struct FaceFrame;

/// A surface under three lights, drawn without a window. There must be a display; see VirtualDisplay.
class SurfaceScene {
 public:
  /// @param surface  gives polygons that are wound outwards
  /// Throws a ValueFailure when the array to colour by is not there.
  SurfaceScene(vtkAlgorithm* surface, const SceneStyle& style);
  ~SurfaceScene();

  /// Frames these points, in place of the surface as it was when the scene was made.
  void placeCamera(vtkPolyData* visible);

  /// Frames the neutral face, or both when these points are not all seen then.
  void placeCamera(vtkPolyData* neutral, vtkPolyData* visible);

  /// Draws the present surface: unsigned char, 4 components, of the size asked for.
  vtkSmartPointer<vtkImageData> render();

 protected:
  const SceneStyle& style() const { return style_; }
  int samplesPerPixel() const { return factor_; }  ///< computed per pixel shown, along each side
  vtkActor* skin() { return surface_; }
  vtkRenderer* renderer() { return renderer_; }

 private:
  FaceFrame frame() const;
  vtkPolyData* shown();
  void addSurface();
  void addLights();
  void addColors();

  vtkSmartPointer<vtkAlgorithm> surfaceSource_;
  SceneStyle style_;
  int factor_;
  vtkNew<vtkPolyDataMapper> surfaceMapper_;
  vtkNew<vtkActor> surface_;
  vtkNew<vtkScalarBarActor> bar_;
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkRenderWindow> window_;
};

}  // namespace mien
