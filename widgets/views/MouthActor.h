#pragma once

#include <vtkNew.h>

class vtkActor;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkProperty;
class vtkRenderer;

namespace mien {

/// The inside of an open mouth in a view of the face, dark unless it is told otherwise: it hides what is behind it.
class MouthActor {
 public:
  explicit MouthActor(vtkRenderer* renderer);

  void follow(vtkPolyData* mouth);  ///< as the face is now (FaceModel::mouth)
  void setVisible(bool visible);
  vtkProperty* property();
  void setBehind(double units);  ///< of depth, so that curves on its rim are seen

 private:
  vtkNew<vtkPolyDataMapper> mapper_;
  vtkNew<vtkActor> actor_;
};

}  // namespace mien
