#include "SurfaceScene.h"

#include <algorithm>

#include "ColorMap.h"
#include "FaceCamera.h"
#include "Failure.h"
#include "OutermostPoints.h"
#include "Picture.h"
#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkTextProperty.h"
#include "vtkWindowToImageFilter.h"

namespace mien {

namespace {

constexpr int largestComputedSide = 8192;  // pixels; common drivers can hold twice as much
constexpr double barShare = 0.14;          // of the picture's width
constexpr double dotsPerInch = 96.0;
constexpr double skinColor[3] = {0.90, 0.86, 0.83};
constexpr double inside[3] = {0.20, 0.15, 0.14};  // dark: an open mouth has depth
constexpr double lines[3] = {0.16, 0.20, 0.26};

int samplingFactor(const SceneStyle& style) {
  return std::clamp(largestComputedSide / std::max(style.width, style.height), 1, style.samples);
}

vtkSmartPointer<vtkLight> cameraLight(double x, double y, double z, double intensity, double warmth) {
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToCameraLight();
  light->SetPosition(x, y, z);
  light->SetFocalPoint(0, 0, 0);
  light->SetIntensity(intensity);
  light->SetColor(1.0, 1.0 - 0.5 * warmth, 1.0 - warmth);
  return light;
}

std::string arrayNames(vtkPolyData* surface) {
  std::string names;
  for (vtkDataSetAttributes* data : {static_cast<vtkDataSetAttributes*>(surface->GetPointData()),
                                     static_cast<vtkDataSetAttributes*>(surface->GetCellData())})
    for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
      const std::string name = data->GetArrayName(i) ? data->GetArrayName(i) : "";
      if (!name.empty() && name.rfind("vtk", 0) != 0) names += (names.empty() ? "" : ", ") + name;
    }
  return names;
}

}  // namespace

SurfaceScene::SurfaceScene(vtkAlgorithm* surface, const SceneStyle& style)
    : surfaceSource_(surface), style_(style), factor_(samplingFactor(style)) {
  surfaceSource_->Update();
  addSurface();
  if (!style.colorBy.empty()) addColors();
  addLights();
  renderer_->SetBackground(style.background.data());
  renderer_->SetBackgroundAlpha(style.transparent ? 0.0 : 1.0);
  window_->OffScreenRenderingOn();
  window_->SetMultiSamples(0);
  window_->SetAlphaBitPlanes(1);
  window_->SetDPI(static_cast<int>(dotsPerInch * factor_));
  window_->SetSize(style.width * factor_, style.height * factor_);
  window_->AddRenderer(renderer_);
  placeCamera(shown());
}

SurfaceScene::~SurfaceScene() = default;

vtkPolyData* SurfaceScene::shown() {
  return vtkPolyData::SafeDownCast(surfaceSource_->GetOutputDataObject(0));
}

void SurfaceScene::addSurface() {
  surfaceMapper_->SetInputConnection(surfaceSource_->GetOutputPort());
  surfaceMapper_->ScalarVisibilityOff();
  surface_->SetMapper(surfaceMapper_);
  vtkProperty* material = surface_->GetProperty();
  material->SetColor(skinColor[0], skinColor[1], skinColor[2]);
  material->SetInterpolationToPhong();
  material->SetAmbient(0.05);
  material->SetDiffuse(0.92);
  material->SetSpecular(0.16);
  material->SetSpecularPower(18.0);
  vtkNew<vtkProperty> back;
  back->DeepCopy(material);
  back->SetColor(inside[0], inside[1], inside[2]);
  back->SetSpecular(0.0);
  surface_->SetBackfaceProperty(back);
  for (vtkProperty* side : {material, back.Get()}) {
    side->SetEdgeColor(lines[0], lines[1], lines[2]);
    side->SetLineWidth(static_cast<float>(0.7 * factor_));
    side->SetEdgeVisibility(style_.mesh == SceneStyle::Mesh::Both);
    if (style_.mesh == SceneStyle::Mesh::Wireframe) {
      side->SetRepresentationToWireframe();
      side->SetColor(lines[0], lines[1], lines[2]);
      side->LightingOff();
    }
  }
  renderer_->AddActor(surface_);
}

/// Key from the upper left, fill from the right, rim from behind.
void SurfaceScene::addLights() {
  renderer_->AutomaticLightCreationOff();
  renderer_->AddLight(cameraLight(-0.75, 0.85, 1.0, 0.86, 0.05));
  renderer_->AddLight(cameraLight(1.0, 0.10, 0.7, 0.42, -0.03));
  renderer_->AddLight(cameraLight(0.4, 0.9, -0.9, 0.35, 0.0));
  renderer_->AddLight(cameraLight(0.0, -0.2, 1.0, 0.16, 0.0));
}

void SurfaceScene::addColors() {
  vtkPolyData* surface = shown();
  const bool onPoints = surface->GetPointData()->HasArray(style_.colorBy.c_str());
  vtkDataArray* array = onPoints ? surface->GetPointData()->GetArray(style_.colorBy.c_str())
                                 : surface->GetCellData()->GetArray(style_.colorBy.c_str());
  if (!array)
    throw ValueFailure("--color-by '" + style_.colorBy + "' is no array of the surface; it has " + arrayNames(surface));
  const bool isPatch = style_.colorBy == "PatchId";
  double range[2];
  array->GetRange(range, array->GetNumberOfComponents() > 1 ? -1 : 0);
  const auto table = isPatch ? patchColorTable() : sequentialColors(range[0], range[1]);
  if (array->GetNumberOfComponents() > 1) table->SetVectorModeToMagnitude();
  surfaceMapper_->ScalarVisibilityOn();
  surfaceMapper_->SetLookupTable(table);
  surfaceMapper_->UseLookupTableScalarRangeOn();
  onPoints ? surfaceMapper_->SetScalarModeToUsePointFieldData() : surfaceMapper_->SetScalarModeToUseCellFieldData();
  surfaceMapper_->SelectColorArray(style_.colorBy.c_str());
  surfaceMapper_->SetColorModeToMapScalars();
  surfaceMapper_->InterpolateScalarsBeforeMappingOn();
  surface_->SetBackfaceProperty(nullptr);
  surface_->GetProperty()->SetSpecular(0.0);
  surface_->GetProperty()->SetAmbient(0.40);  // light enough to show the shape, not so much that colours leave the bar
  surface_->GetProperty()->SetDiffuse(0.52);
  bar_->SetLookupTable(table);
  bar_->SetTitle(style_.colorBy.c_str());
  bar_->SetDrawAnnotations(isPatch);
  bar_->SetNumberOfLabels(isPatch ? 0 : 5);
  bar_->SetPosition(1.0 - barShare, 0.15);
  bar_->SetPosition2(0.8 * barShare, 0.7);
  bar_->UnconstrainedFontSizeOn();
  for (vtkTextProperty* text :
       {bar_->GetTitleTextProperty(), bar_->GetLabelTextProperty(), bar_->GetAnnotationTextProperty()}) {
    text->SetColor(0.1, 0.1, 0.1);
    text->SetFontSize(std::clamp(style_.height / 70, 8, 24));
    text->ItalicOff();
    text->BoldOff();
    text->ShadowOff();
  }
  renderer_->AddViewProp(bar_);
}

FaceFrame SurfaceScene::frame() const {
  FaceFrame frame;
  frame.aspect = static_cast<double>(style_.width) / style_.height;
  frame.freeShare = style_.colorBy.empty() ? 1.0 : 1.0 - barShare;
  return frame;
}

void SurfaceScene::placeCamera(vtkPolyData* visible) {
  placeFaceCamera(visible, style_.view, frame(), renderer_->GetActiveCamera());
}

void SurfaceScene::placeCamera(vtkPolyData* neutral, vtkPolyData* visible) {
  placeCamera(neutral);
  if (isWithinFrame(visible, style_.view, frame(), renderer_->GetActiveCamera())) return;
  OutermostPoints both(style_.view);
  both.add(neutral->GetPoints());
  both.add(visible->GetPoints());
  placeCamera(both.points());
}

vtkSmartPointer<vtkImageData> SurfaceScene::render() {
  surfaceSource_->Update();
  renderer_->ResetCameraClippingRange();
  window_->Render();
  vtkNew<vtkWindowToImageFilter> capture;
  capture->SetInput(window_);
  capture->SetInputBufferTypeToRGBA();
  capture->ReadFrontBufferOff();
  capture->ShouldRerenderOff();
  capture->Update();
  const auto picture = reduced(capture->GetOutput(), factor_);
  return style_.transparent ? picture : opaque(picture);
}

}  // namespace mien
