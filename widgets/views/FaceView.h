#pragma once

#include <QColor>

#include "MouthActor.h"
#include "RenderView.h"

class vtkActor;
class vtkImageData;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkProperty;
class vtkReverseSense;
class vtkTexture;

namespace mien {

class ColorLegend;
struct FaceArray;

/// What does the face look like? The surface, lit, as its mesh, both, or its points; in its skin or in colours that say
/// something.
class FaceView : public RenderView {
  Q_OBJECT
 public:
  enum class Mesh { Shaded, Wireframe, Both, Points };

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

  /// Shows a surface in place of the pipeline's; nullptr: the pipeline's.
  /// @param isOutwards  whether its cells are wound outwards, as those of a mesh from a file; the pipeline's are not
  void showSurface(vtkPolyData* surface, bool isOutwards = true);

  /// Colours the surface by an array of it, whatever its mesh looks like; nullptr: the skin again.
  /// @param legend  must live while it is shown
  void setColors(const FaceArray& array, const ColorLegend* legend);

  /// Says that a scan lies over the skin, in a colour with its opacity; an invalid colour: none.
  void tellScan(const QColor& color);
  const QColor& scan() const { return scan_; }

  void useTheme() override;
  bool showsSurface() const override;

 signals:
  void overlayChanged(const QObject* overlay);
  void scanChanged();

 private:
  bool isOpen() const { return mesh_ == Mesh::Wireframe || mesh_ == Mesh::Points; }  ///< what is behind it is seen
  void addSurface();
  void dress();
  void dressSkin();
  void showMouth();
  void dressLines(vtkProperty* side) const;

  vtkNew<vtkReverseSense> outwards_;
  vtkNew<vtkActor> surface_;
  vtkNew<vtkPolyDataMapper> mapper_;
  vtkNew<vtkProperty> inside_;
  vtkNew<vtkTexture> texture_;
  MouthActor mouth_{renderer()};
  Mesh mesh_ = Mesh::Shaded;
  QColor scan_;
  bool textured_ = false, colored_ = false, foreign_ = false;
};

}  // namespace mien
