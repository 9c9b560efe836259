#pragma once

#include <vtkNew.h>

class vtkActor;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkRenderer;

namespace mien {

/// The dark inside of an open mouth in a view of the face.
class MouthActor {
 public:
  explicit MouthActor(vtkRenderer* renderer);

  void follow(vtkPolyData* curves);  ///< as the face is now
  void setVisible(bool visible);

 private:
  vtkNew<vtkPolyDataMapper> mapper_;
  vtkNew<vtkActor> actor_;
};

}  // namespace mien
