#include "FaceOverlay.h"

#include <vtkActor.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>

#include <QEvent>

#include "FaceView.h"
#include "Theme.h"

namespace mien {

namespace {

constexpr float chosenWidth = 5.0f;      // pixels
constexpr double towardsCamera = -60.0;  // depth units by which lines lie before the skin that they are on

void setMatt(vtkActor* actor) {
  actor->GetProperty()->SetAmbient(0.12);
  actor->GetProperty()->SetDiffuse(0.85);
  actor->GetProperty()->SetInterpolationToPhong();
}

}  // namespace

FaceOverlay::FaceOverlay(FaceView* view, const QString& dock, QObject* parent)
    : QObject(parent), view_(view), dock_(dock) {
  surface_->SetMapper(surfaceMapper_);
  zebra_->SetMapper(zebraMapper_);
  lines_->SetMapper(lineMapper_);
  zebraMapper_->ScalarVisibilityOff();
  setMatt(surface_);
  setMatt(zebra_);
  addZebraShader();
  lines_->GetProperty()->LightingOff();
  lines_->GetProperty()->SetLineWidth(chosenWidth);
  lineMapper_->SetResolveCoincidentTopologyToPolygonOffset();
  lineMapper_->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, towardsCamera);
  useTheme();
  view_->installEventFilter(this);
  connect(view_, &FaceView::overlayChanged, this, [this](const QObject* overlay) {
    if (overlay != this) remove();
  });
}

FaceOverlay::~FaceOverlay() = default;

/// Bands of equal angle between the normal and one direction across the view: where a surface has a crease the bands
/// break, where its curvature jumps they have a corner.
void FaceOverlay::addZebraShader() {
  zebra_->GetShaderProperty()->AddFragmentShaderReplacement(
      "//VTK::Light::Impl", true,
      "//VTK::Light::Impl\n"
      "  float zebra = 16.0 * asin(clamp(dot(normalVCVSOutput, vec3(0.35, 0.94, 0.0)), -1.0, 1.0)) / 3.14159265;\n"
      "  float distance = abs(fract(zebra) - 0.5) - 0.25;\n"
      "  float light = smoothstep(-0.5, 0.5, distance / max(fwidth(zebra), 0.0001));\n"
      "  fragOutput0 = vec4(fragOutput0.rgb * mix(0.16, 1.0, light), 1.0);\n",
      false);
}

void FaceOverlay::color(vtkPolyDataMapper* mapper, const char* array, const Scale& scale) {
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray(array);
  legend_.setScale(scale);
  legend_.color(mapper);
}

/// Of a scale that ends before the values do, it is told.
FaceOverlay::Scale FaceOverlay::marked(vtkPolyData* data, const char* array, const Scale& scale) {
  Scale told = scale;
  if (!data) return told;
  if (vtkDataArray* values = data->GetPointData()->GetArray(array)) told.mark(values->GetFiniteRange(0));
  return told;
}

void FaceOverlay::showSurface(vtkPolyData* surface, const char* array, const Scale& scale) {
  color(surfaceMapper_, array, scale);
  surfaceMapper_->SetInputData(surface);
  show(surface_, false, marked(surface, array, scale));
}

void FaceOverlay::showColors(vtkPolyData* surface, const char* array) {
  surfaceMapper_->SetScalarModeToUsePointFieldData();
  surfaceMapper_->SelectColorArray(array);
  surfaceMapper_->SetColorModeToDirectScalars();
  surfaceMapper_->InterpolateScalarsBeforeMappingOff();
  surfaceMapper_->SetInputData(surface);
  show(surface_, false, {});
}

void FaceOverlay::showZebra(vtkPolyData* surface) {
  zebraMapper_->SetInputData(surface);
  show(zebra_, false, {});
}

void FaceOverlay::showLines(vtkPolyData* lines, const char* array, const Scale& scale) {
  color(lineMapper_, array, scale);
  lineMapper_->SetInputData(lines);
  show(lines_, true, marked(lines, array, scale));
}

QString FaceOverlay::words() const {
  return tr("%1 (%2 dock)").arg(subject_, dock_);
}

void FaceOverlay::show(vtkActor* actor, bool withSkin, const std::optional<Scale>& scale) {
  const bool changes = !shown_;
  shown_ = true;
  scale_ = scale;
  view_->showOverlay(this, withSkin);
  for (vtkActor* other : {surface_.Get(), zebra_.Get(), lines_.Get()})
    other == actor ? view_->renderer()->AddActor(other) : view_->renderer()->RemoveActor(other);
  view_->redraw();
  if (changes) emit shownChanged(true);
}

void FaceOverlay::hide() {
  if (shown_) view_->showOverlay(nullptr, true);
}

void FaceOverlay::remove() {
  if (!shown_) return;
  shown_ = false;
  for (vtkActor* actor : {surface_.Get(), zebra_.Get(), lines_.Get()}) view_->renderer()->RemoveActor(actor);
  view_->redraw();
  emit shownChanged(false);
}

bool FaceOverlay::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::PaletteChange) useTheme();
  return QObject::eventFilter(watched, event);
}

void FaceOverlay::useTheme() {
  const Theme& theme = Theme::current();
  zebra_->GetProperty()->SetColor(theme.skin.redF(), theme.skin.greenF(), theme.skin.blueF());
}

}  // namespace mien
