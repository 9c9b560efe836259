#include "FaceOverlay.h"

#include <vtkActor.h>
#include <vtkColorTransferFunction.h>
#include <vtkLookupTable.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkShaderProperty.h>
#include <vtkTextProperty.h>

#include <QEvent>
#include <iterator>

#include "FaceView.h"
#include "Theme.h"

namespace mien {

namespace {

constexpr int viridis[] = {0x440154, 0x472d7b, 0x3b528b, 0x2c728e, 0x21918c, 0x28ae80, 0x5ec962, 0xaddc30, 0xfde725};
constexpr int blueToOrange[] = {0x16467f, 0x3b7bb8, 0x8fb8dc, 0xf2f2ef, 0xf0b27f, 0xd4772f, 0x8a4206};
constexpr int steps = 256;
constexpr float lineWidth = 5.0f;        // pixels
constexpr double towardsCamera = -60.0;  // depth units by which lines lie before the skin that they are on

double part(int color, int shift) {
  return ((color >> shift) & 0xff) / 255.0;
}

template <size_t count>
void fill(vtkLookupTable* table, const int (&colors)[count]) {
  vtkNew<vtkColorTransferFunction> function;
  for (size_t i = 0; i < count; ++i)
    function->AddRGBPoint(i / (count - 1.0), part(colors[i], 16), part(colors[i], 8), part(colors[i], 0));
  table->SetNumberOfTableValues(steps);
  for (int i = 0; i < steps; ++i) {
    double color[3];
    function->GetColor(i / (steps - 1.0), color);
    table->SetTableValue(i, color[0], color[1], color[2]);
  }
}

void setMatt(vtkActor* actor) {
  actor->GetProperty()->SetAmbient(0.12);
  actor->GetProperty()->SetDiffuse(0.85);
  actor->GetProperty()->SetInterpolationToPhong();
}

}  // namespace

FaceOverlay::FaceOverlay(FaceView* view, QObject* parent) : QObject(parent), view_(view) {
  surface_->SetMapper(surfaceMapper_);
  zebra_->SetMapper(zebraMapper_);
  lines_->SetMapper(lineMapper_);
  zebraMapper_->ScalarVisibilityOff();
  setMatt(surface_);
  setMatt(zebra_);
  addZebraShader();
  lines_->GetProperty()->LightingOff();
  lines_->GetProperty()->SetLineWidth(lineWidth);
  lineMapper_->SetResolveCoincidentTopologyToPolygonOffset();
  lineMapper_->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, towardsCamera);
  bar_->SetLookupTable(colors_);
  bar_->SetOrientationToVertical();  // beside the face, not on its chin
  bar_->SetNumberOfLabels(5);
  bar_->SetLabelFormat("%.3g");
  bar_->SetPosition(0.02, 0.12);
  bar_->SetPosition2(0.2, 0.76);
  bar_->SetBarRatio(0.16);
  bar_->SetVerticalTitleSeparation(8);
  bar_->UnconstrainedFontSizeOn();
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
  scale.colors == Colors::Diverging ? fill(colors_, blueToOrange) : fill(colors_, viridis);
  colors_->SetTableRange(scale.begin, scale.end);
  colors_->SetNanColor(0.5, 0.5, 0.5, 1.0);
  colors_->Modified();
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray(array);
  mapper->SetColorModeToMapScalars();
  mapper->SetLookupTable(colors_);
  mapper->UseLookupTableScalarRangeOn();
  mapper->InterpolateScalarsBeforeMappingOn();
  bar_->SetTitle(scale.title.toUtf8().constData());
}

void FaceOverlay::showSurface(vtkPolyData* surface, const char* array, const Scale& scale) {
  color(surfaceMapper_, array, scale);
  surfaceMapper_->SetInputData(surface);
  show(surface_, false, true);
}

void FaceOverlay::showColors(vtkPolyData* surface, const char* array) {
  surfaceMapper_->SetScalarModeToUsePointFieldData();
  surfaceMapper_->SelectColorArray(array);
  surfaceMapper_->SetColorModeToDirectScalars();
  surfaceMapper_->InterpolateScalarsBeforeMappingOff();
  surfaceMapper_->SetInputData(surface);
  show(surface_, false, false);
}

void FaceOverlay::showZebra(vtkPolyData* surface) {
  zebraMapper_->SetInputData(surface);
  show(zebra_, false, false);
}

void FaceOverlay::showLines(vtkPolyData* lines, const char* array, const Scale& scale) {
  color(lineMapper_, array, scale);
  lineMapper_->SetInputData(lines);
  show(lines_, true, true);
}

void FaceOverlay::show(vtkActor* actor, bool withSkin, bool withScale) {
  const bool changes = !shown_;
  shown_ = true;
  view_->showOverlay(this, withSkin);
  for (vtkActor* other : {surface_.Get(), zebra_.Get(), lines_.Get()})
    other == actor ? view_->renderer()->AddActor(other) : view_->renderer()->RemoveActor(other);
  withScale ? view_->renderer()->AddActor2D(bar_) : view_->renderer()->RemoveActor2D(bar_);
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
  view_->renderer()->RemoveActor2D(bar_);
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
  for (vtkTextProperty* text : {bar_->GetTitleTextProperty(), bar_->GetLabelTextProperty()}) {
    text->SetFontSize(11);
    text->ItalicOff();
    text->BoldOff();
    text->ShadowOff();
    text->SetColor(theme.text.redF(), theme.text.greenF(), theme.text.blueF());
  }
}

}  // namespace mien
