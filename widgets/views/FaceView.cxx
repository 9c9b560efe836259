#include "FaceView.h"

#include <vtkActor.h>
#include <vtkAlgorithm.h>
#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkReverseSense.h>
#include <vtkTexture.h>

#include "FaceModel.h"
#include "Theme.h"

namespace mien {

namespace {

constexpr float meshWidth = 1.0f;     // pixels
const QColor mouthInside("#5c2421");  // inside of a face with a photograph, which does not show it

void setColor(vtkProperty* property, const QColor& color) {
  property->SetColor(color.redF(), color.greenF(), color.blueF());
}

void setSkin(vtkProperty* property) {
  property->SetInterpolationToPhong();
  property->SetAmbient(0.05);
  property->SetDiffuse(0.92);
  property->SetSpecular(0.16);
  property->SetSpecularPower(18.0);
}

}  // namespace

FaceView::FaceView(FaceModel* model, QWidget* parent) : RenderView(model, parent) {
  setObjectName("faceView");
  setToolTip(
      tr("Drag to turn, wheel or right button to zoom, Shift and drag to move, double click to see the whole face"));
  texture_->InterpolateOn();
  texture_->MipmapOn();
  texture_->RepeatOff();
  texture_->EdgeClampOn();
  addSurface();
  dress();
  const auto followMouth = [this, model] {
    mouth_.follow(vtkPolyData::SafeDownCast(model->pipeline().shownCurves()->GetOutputDataObject(0)));
  };
  connect(model, &FaceModel::updated, this, followMouth);
  followMouth();
}

FaceView::~FaceView() = default;

void FaceView::addSurface() {
  outwards_->SetInputConnection(model().pipeline().surface()->GetOutputPort());  // VTK winds the grid's cells inwards
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(outwards_->GetOutputPort());
  mapper->ScalarVisibilityOff();
  surface_->SetMapper(mapper);
  vtkNew<vtkProperty> inside;
  surface_->SetBackfaceProperty(inside);
  renderer()->AddActor(surface_);
}

void FaceView::dress() {
  const Theme& theme = Theme::current();
  const bool wires = mesh_ == Mesh::Wireframe;
  const bool photograph = textured_ && !wires;
  surface_->SetTexture(photograph ? texture_.Get() : nullptr);
  setColor(surface_->GetProperty(), wires ? theme.mesh : photograph ? QColor(Qt::white) : theme.skin);
  setColor(surface_->GetBackfaceProperty(), wires ? theme.ghost : photograph ? mouthInside : theme.skinInside);
  for (vtkProperty* side : {surface_->GetProperty(), surface_->GetBackfaceProperty()}) {
    setSkin(side);
    side->SetRepresentation(wires ? VTK_WIREFRAME : VTK_SURFACE);
    side->SetLighting(!wires);
    side->SetLineWidth(meshWidth);
    side->SetEdgeVisibility(mesh_ == Mesh::Both);
    side->SetEdgeColor(theme.mesh.redF(), theme.mesh.greenF(), theme.mesh.blueF());
  }
  surface_->GetBackfaceProperty()->SetSpecular(0.0);
}

void FaceView::setMesh(Mesh mesh) {
  mesh_ = mesh;
  mouth_.setVisible(mesh_ != Mesh::Wireframe);
  dress();
  redraw();
}

void FaceView::showOverlay(const QObject* overlay, bool skinStays) {
  surface_->SetVisibility(skinStays);
  redraw();
  emit overlayChanged(overlay);
}

void FaceView::setTexture(vtkImageData* image) {
  textured_ = image != nullptr;
  if (image) texture_->SetInputData(image);
  dress();
  redraw();
}

void FaceView::useTheme() {
  dress();
  RenderView::useTheme();
}

}  // namespace mien
