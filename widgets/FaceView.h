#pragma once

#include "RenderView.h"

class vtkActor;
class vtkReverseSense;

namespace mien {

/// What does the face look like? The surface, lit, as its mesh, or both.
class FaceView : public RenderView {
  Q_OBJECT
 public:
  enum class Mesh { Shaded, Wireframe, Both };

  FaceView(FaceModel* model, QWidget* parent = nullptr);
  ~FaceView() override;

  void setMesh(Mesh mesh);
  Mesh mesh() const { return mesh_; }
  void useTheme() override;

 private:
  void addSurface();
  void dress();

  vtkNew<vtkReverseSense> outwards_;
  vtkNew<vtkActor> surface_;
  Mesh mesh_ = Mesh::Shaded;
};

}  // namespace mien
