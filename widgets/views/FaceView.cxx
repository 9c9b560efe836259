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

#include "ColorLegend.h"
#include "FaceArray.h"
#include "FaceModel.h"
#include "PropertyColor.h"
#include "Theme.h"

namespace mien {

namespace {

constexpr float meshWidth = 1.0f, shownPointSize = 3.0f;  // pixels
constexpr int lipsDarker = 110;                           // percent, than skin without light and shadow
const QColor mouthInside("#5c2421");                      // inside of a face with a photograph, which does not show it

void setSkin(vtkProperty* property) {
  property->SetInterpolationToPhong();
  property->SetAmbient(0.05);
  property->SetDiffuse(0.92);
  property->SetSpecular(0.16);
  property->SetSpecularPower(18.0);
}

void setMatt(vtkProperty* property) {
  property->SetAmbient(0.30);
  property->SetDiffuse(0.64);
  property->SetSpecular(0.0);
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
  const auto followMouth = [this, model] { mouth_.follow(model->mouth()); };
  connect(model, &FaceModel::updated, this, followMouth);
  followMouth();
}

FaceView::~FaceView() = default;

void FaceView::addSurface() {
  outwards_->SetInputConnection(model().pipeline().surface()->GetOutputPort());  // VTK winds the grid's cells inwards
  mapper_->SetInputConnection(outwards_->GetOutputPort());
  mapper_->ScalarVisibilityOff();
  surface_->SetMapper(mapper_);
  renderer()->AddActor(surface_);
}

/// Colours that say something are the same from both sides, and light enough that they do not leave their scale.
void FaceView::dress() {
  surface_->SetTexture(textured_ && !colored_ && !isOpen() ? texture_.Get() : nullptr);
  surface_->SetBackfaceProperty(colored_ ? nullptr : inside_.Get());
  dressSkin();
  if (colored_) setMatt(surface_->GetProperty());
  dressLines(surface_->GetProperty());
  dressLines(inside_);
}

void FaceView::dressSkin() {
  const Theme& theme = Theme::current();
  setColor(surface_->GetProperty(), isOpen() ? theme.meshAlone : textured_ ? QColor(Qt::white) : theme.skin);
  setColor(inside_, isOpen() ? theme.ghost : textured_ ? mouthInside : theme.skinInside);
  mouth_.fadeFrom(colored_ ? QColor() : theme.skin.darker(lipsDarker));
  for (vtkProperty* side : {surface_->GetProperty(), inside_.Get()}) setSkin(side);
  inside_->SetSpecular(0.0);
}

void FaceView::dressLines(vtkProperty* side) const {
  const Theme& theme = Theme::current();
  side->SetRepresentation(mesh_ == Mesh::Points ? VTK_POINTS : mesh_ == Mesh::Wireframe ? VTK_WIREFRAME : VTK_SURFACE);
  side->SetLighting(!isOpen());
  side->SetLineWidth(meshWidth);
  side->SetPointSize(shownPointSize);
  side->SetEdgeVisibility(mesh_ == Mesh::Both);
  side->SetEdgeColor(theme.mesh.redF(), theme.mesh.greenF(), theme.mesh.blueF());
}

/// What a dock shows in its place is lit, whatever the mesh.
bool FaceView::showsSurface() const {
  return !isOpen() || !surface_->GetVisibility();
}

void FaceView::setMesh(Mesh mesh) {
  mesh_ = mesh;
  showMouth();
  dress();
  redraw();
}

/// A mesh of a file has a mouth of its own.
void FaceView::showMouth() {
  mouth_.setVisible(!foreign_ && (mesh_ == Mesh::Shaded || mesh_ == Mesh::Both));
}

void FaceView::showSurface(vtkPolyData* surface, bool isOutwards) {
  foreign_ = surface && isOutwards;
  if (foreign_) {
    mapper_->SetInputData(surface);
  } else {
    surface ? outwards_->SetInputData(surface)
            : outwards_->SetInputConnection(model().pipeline().surface()->GetOutputPort());
    mapper_->SetInputConnection(outwards_->GetOutputPort());
  }
  showMouth();
  redraw();
}

void FaceView::setColors(const FaceArray& array, const ColorLegend* legend) {
  colored_ = legend != nullptr;
  if (colored_) {
    array.ofCells ? mapper_->SetScalarModeToUseCellFieldData() : mapper_->SetScalarModeToUsePointFieldData();
    mapper_->SelectColorArray(array.name.c_str());
    legend->color(mapper_, array.component);
  } else {
    mapper_->ScalarVisibilityOff();
  }
  dress();
  redraw();
}

void FaceView::showOverlay(const QObject* overlay, bool skinStays) {
  surface_->SetVisibility(skinStays);
  redraw();
  emit overlayChanged(overlay);
}

void FaceView::tellScan(const QColor& color) {
  scan_ = color;
  emit scanChanged();
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
