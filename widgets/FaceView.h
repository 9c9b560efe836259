#pragma once

#include "MouthActor.h"
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

  /// Says who shows numbers on the face; nullptr: nobody, the plain skin again.
  /// @param skinStays  whether the plain skin is seen below
  void showOverlay(const QObject* overlay, bool skinStays);

  void useTheme() override;

 signals:
  void overlayChanged(const QObject* overlay);

 private:
  void addSurface();
  void dress();

  vtkNew<vtkReverseSense> outwards_;
  vtkNew<vtkActor> surface_;
  MouthActor mouth_{renderer()};
  Mesh mesh_ = Mesh::Shaded;
};

}  // namespace mien
