#include "FaceScene.h"

#include "FaceMotion.h"
#include "FaceOptions.h"
#include "FacePipeline.h"
#include "FaceTexture.h"
#include "Failure.h"
#include "MouthSack.h"
#include "SmoothCurves.h"
#include "vtkActor.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkReverseSense.h"
#include "vtkTexture.h"

namespace mien {

namespace {

constexpr double curveOffset = -120.0;  // in 1.6e-5 of the depth drawn, together about 0.5 mm of a head

constexpr double curveColor[3] = {0.05, 0.28, 0.55};

/// The surface's polygons are wound inwards.
vtkSmartPointer<vtkAlgorithm> outwards(FacePipeline& pipeline) {
  const auto reversed = vtkSmartPointer<vtkReverseSense>::New();
  reversed->SetInputConnection(pipeline.surface()->GetOutputPort());
  return reversed;
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
    : SurfaceScene(outwards(pipeline), style), pipeline_(pipeline) {
  if (showsMouth()) addMouth();
  if (texture) addTexture(texture);
  if (style.curves) addCurves();
}

FaceScene::~FaceScene() = default;

bool FaceScene::showsMouth() const {
  return style().mesh != SceneStyle::Mesh::Wireframe && style().colorBy.empty();
}

/// Else the background shows through an open mouth wherever the back of the head ends.
void FaceScene::addMouth() {
  mouthMapper_->SetInputData(mouthSack(nullptr));
  mouthMapper_->ScalarVisibilityOff();
  vtkNew<vtkActor> mouth;
  mouth->SetMapper(mouthMapper_);
  mouth->GetProperty()->LightingOff();
  mouth->GetProperty()->SetColor(mouthColor[0], mouthColor[1], mouthColor[2]);
  renderer()->AddActor(mouth);
}

/// Colours come from the photograph alone. The inside of the mouth, which it does not show, stays as it is.
void FaceScene::addTexture(vtkImageData* image) {
  if (!style().colorBy.empty()) throw ValueFailure("--texture and --color-by both colour the surface; give one");
  if (style().mesh == SceneStyle::Mesh::Wireframe)
    throw ValueFailure("--texture needs a surface; leave out --style wireframe");
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOn();
  texture->MipmapOn();
  texture->RepeatOff();
  texture->EdgeClampOn();
  skin()->SetTexture(texture);
  skin()->GetProperty()->SetColor(1.0, 1.0, 1.0);
}

void FaceScene::addCurves() {
  curveMapper_->ScalarVisibilityOff();
  // The curves lie in the surface: they are drawn as if a little nearer.
  curveMapper_->SetResolveCoincidentTopologyToPolygonOffset();
  curveMapper_->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, curveOffset);
  curves_->SetMapper(curveMapper_);
  curves_->GetProperty()->SetColor(curveColor[0], curveColor[1], curveColor[2]);
  curves_->GetProperty()->LightingOff();
  curves_->GetProperty()->SetLineWidth(static_cast<float>(1.6 * samplesPerPixel()));
  renderer()->AddActor(curves_);
}

void FaceScene::updateCurves() {
  curveMapper_->SetInputData(smoothCurves(vtkPolyData::SafeDownCast(pipeline_.shownCurves()->GetOutputDataObject(0))));
}

vtkSmartPointer<vtkImageData> FaceScene::render() {
  pipeline_.shownCurves()->Update();
  auto* curves = vtkPolyData::SafeDownCast(pipeline_.shownCurves()->GetOutputDataObject(0));
  if (showsMouth()) mouthMapper_->SetInputData(mouthSack(curves));
  if (style().curves) updateCurves();
  return SurfaceScene::render();
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

}  // namespace mien
