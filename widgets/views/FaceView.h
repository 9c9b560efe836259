#pragma once

#include "MouthActor.h"
#include "RenderView.h"

class vtkActor;
class vtkImageData;
class vtkReverseSense;
class vtkTexture;

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

  /// Colours of a photograph for the skin, over the surface's (u, v); nullptr: the plain skin. Lines of a mesh stay
  /// plain.
  void setTexture(vtkImageData* image);
  bool isTextured() const { return textured_; }

  void useTheme() override;

 signals:
  void overlayChanged(const QObject* overlay);

 private:
  void addSurface();
  void dress();

  vtkNew<vtkReverseSense> outwards_;
  vtkNew<vtkActor> surface_;
  vtkNew<vtkTexture> texture_;
  MouthActor mouth_{renderer()};
  Mesh mesh_ = Mesh::Shaded;
  bool textured_ = false;
};

}  // namespace mien
