#include "FaceView.h"

#include <vtkActor.h>
#include <vtkAlgorithm.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkReverseSense.h>

#include "FaceModel.h"
#include "Theme.h"

namespace mien {

namespace {

constexpr float meshWidth = 1.0f;  // pixels

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
  addSurface();
  dress();
  const auto followMouth = [this, model] {
    mouth_.follow(vtkPolyData::SafeDownCast(model->pipeline().curves()->GetOutputDataObject(0)));
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
  setColor(surface_->GetProperty(), wires ? theme.mesh : theme.skin);
  setColor(surface_->GetBackfaceProperty(), wires ? theme.ghost : theme.skinInside);
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

void FaceView::useTheme() {
  dress();
  RenderView::useTheme();
}

}  // namespace mien
