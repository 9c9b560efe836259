#include "FaceScene.h"

#include <algorithm>

#include "ColorMap.h"
#include "FaceCamera.h"
#include "FaceMotion.h"
#include "FaceOptions.h"
#include "FacePipeline.h"
#include "FaceTexture.h"
#include "Failure.h"
#include "MouthSack.h"
#include "OutermostPoints.h"
#include "Picture.h"
#include "SmoothCurves.h"
#include "vtkActor.h"
#include "vtkBoundaryCurveReader.h"
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
#include "vtkReverseSense.h"
#include "vtkScalarBarActor.h"
#include "vtkTextProperty.h"
#include "vtkTexture.h"
#include "vtkWindowToImageFilter.h"

namespace mien {

namespace {

constexpr int largestComputedSide = 8192;  // pixels; common drivers can hold twice as much
constexpr double barShare = 0.14;          // of the picture's width
constexpr double dotsPerInch = 96.0;
constexpr double curveOffset = -120.0;  // in 1.6e-5 of the depth drawn, together about 0.5 mm of a head

constexpr double skin[3] = {0.90, 0.86, 0.83};
constexpr double inside[3] = {0.20, 0.15, 0.14};  // dark: an open mouth has depth
constexpr double lines[3] = {0.16, 0.20, 0.26};
constexpr double curveColor[3] = {0.05, 0.28, 0.55};

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

vtkSmartPointer<vtkImageData> faceTexture(FacePipeline& pipeline) {
  if (pipeline.state().texture.empty()) return nullptr;
  const auto image = vtkSmartPointer<vtkImageData>::New();
  const std::string fault = makeFaceTexture(pipeline.state(), pipeline.neutralCurves()->GetOutput(), image);
  if (!fault.empty()) throw FileFailure(fault);
  return image;
}

FaceScene::FaceScene(FacePipeline& pipeline, const SceneStyle& style, const vtkSmartPointer<vtkImageData>& texture)
    : pipeline_(pipeline), style_(style), factor_(samplingFactor(style)) {
  outwards_->SetInputConnection(pipeline.surface()->GetOutputPort());
  outwards_->Update();
  addSurface();
  if (style.mesh != SceneStyle::Mesh::Wireframe && style.colorBy.empty()) addMouth();
  if (texture) addTexture(texture);
  if (!style.colorBy.empty()) addColors();
  if (style.curves) addCurves();
  addLights();
  renderer_->SetBackground(style.background.data());
  renderer_->SetBackgroundAlpha(style.transparent ? 0.0 : 1.0);
  window_->OffScreenRenderingOn();
  window_->SetMultiSamples(0);
  window_->SetAlphaBitPlanes(1);
  window_->SetDPI(static_cast<int>(dotsPerInch * factor_));
  window_->SetSize(style.width * factor_, style.height * factor_);
  window_->AddRenderer(renderer_);
  placeCamera(outwards_->GetOutput());
}

FaceScene::~FaceScene() = default;

void FaceScene::addSurface() {
  surfaceMapper_->SetInputConnection(outwards_->GetOutputPort());
  surfaceMapper_->ScalarVisibilityOff();
  surface_->SetMapper(surfaceMapper_);
  vtkProperty* material = surface_->GetProperty();
  material->SetColor(skin[0], skin[1], skin[2]);
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

/// Else the background shows through an open mouth wherever the back of the head ends.
void FaceScene::addMouth() {
  mouthMapper_->SetInputData(mouthSack(nullptr));
  mouthMapper_->ScalarVisibilityOff();
  vtkNew<vtkActor> mouth;
  mouth->SetMapper(mouthMapper_);
  mouth->GetProperty()->LightingOff();
  mouth->GetProperty()->SetColor(mouthColor[0], mouthColor[1], mouthColor[2]);
  renderer_->AddActor(mouth);
}

/// Colours come from the photograph alone. The inside of the mouth, which it does not show, stays as it is.
void FaceScene::addTexture(vtkImageData* image) {
  if (!style_.colorBy.empty()) throw ValueFailure("--texture and --color-by both colour the surface; give one");
  if (style_.mesh == SceneStyle::Mesh::Wireframe)
    throw ValueFailure("--texture needs a surface; leave out --style wireframe");
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOn();
  texture->MipmapOn();
  texture->RepeatOff();
  texture->EdgeClampOn();
  surface_->SetTexture(texture);
  surface_->GetProperty()->SetColor(1.0, 1.0, 1.0);
}

void FaceScene::addCurves() {
  curveMapper_->ScalarVisibilityOff();
  // The curves lie in the surface: they are drawn as if a little nearer.
  curveMapper_->SetResolveCoincidentTopologyToPolygonOffset();
  curveMapper_->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, curveOffset);
  curves_->SetMapper(curveMapper_);
  curves_->GetProperty()->SetColor(curveColor[0], curveColor[1], curveColor[2]);
  curves_->GetProperty()->LightingOff();
  curves_->GetProperty()->SetLineWidth(static_cast<float>(1.6 * factor_));
  renderer_->AddActor(curves_);
}

void FaceScene::updateCurves() {
  curveMapper_->SetInputData(smoothCurves(vtkPolyData::SafeDownCast(pipeline_.shownCurves()->GetOutputDataObject(0))));
}

/// Key from the upper left, fill from the right, rim from behind.
void FaceScene::addLights() {
  renderer_->AutomaticLightCreationOff();
  renderer_->AddLight(cameraLight(-0.75, 0.85, 1.0, 0.86, 0.05));
  renderer_->AddLight(cameraLight(1.0, 0.10, 0.7, 0.42, -0.03));
  renderer_->AddLight(cameraLight(0.4, 0.9, -0.9, 0.35, 0.0));
  renderer_->AddLight(cameraLight(0.0, -0.2, 1.0, 0.16, 0.0));
}

void FaceScene::addColors() {
  vtkPolyData* surface = outwards_->GetOutput();
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

FaceFrame FaceScene::frame() const {
  FaceFrame frame;
  frame.aspect = static_cast<double>(style_.width) / style_.height;
  frame.freeShare = style_.colorBy.empty() ? 1.0 : 1.0 - barShare;
  return frame;
}

void FaceScene::placeCamera(vtkPolyData* visible) {
  placeFaceCamera(visible, style_.view, frame(), renderer_->GetActiveCamera());
}

void FaceScene::placeCamera(vtkPolyData* neutral, vtkPolyData* visible) {
  placeCamera(neutral);
  if (isWithinFrame(visible, style_.view, frame(), renderer_->GetActiveCamera())) return;
  OutermostPoints both(style_.view);
  both.add(neutral->GetPoints());
  both.add(visible->GetPoints());
  placeCamera(both.points());
}

vtkSmartPointer<vtkPolyData> neutralSurface(FacePipeline& pipeline) {
  const FaceState state = pipeline.state();
  pipeline.setState(FaceMotion::neutralOf(state));
  updateOrThrow(pipeline);
  const auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(pipeline.surface()->GetOutputDataObject(0));
  pipeline.setState(state);
  return copy;
}

vtkSmartPointer<vtkImageData> FaceScene::render() {
  outwards_->Update();
  pipeline_.shownCurves()->Update();
  mouthMapper_->SetInputData(mouthSack(vtkPolyData::SafeDownCast(pipeline_.shownCurves()->GetOutputDataObject(0))));
  if (style_.curves) updateCurves();
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
