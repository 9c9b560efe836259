#include "FigureContext.h"

#include <cmath>

#include "BoundaryCurveData.h"
#include "FaceMotion.h"
#include "FaceNote.h"
#include "FaceOptions.h"
#include "FaceScene.h"
#include "Failure.h"
#include "FigureCatalogue.h"
#include "FigurePainter.h"
#include "OutermostPoints.h"
#include "PicturePanel.h"
#include "PlatePainter.h"
#include "vtkAlgorithm.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"

namespace mien {

namespace {

int pixelsOf(double millimetres, double dotsPerInch) {
  return std::max(1, static_cast<int>(std::lround(millimetres / 25.4 * dotsPerInch)));
}

}  // namespace

FigureContext::FigureContext(const FaceState& state, const FigureSettings& settings)
    : asked_(state), state_(state), settings_(settings) {}

void FigureContext::begin(const CatalogueFigure& figure) {
  state_ = heededState(figure, asked_);
  showsFace_ = figure.heeds.face;
}

FacePipeline& FigureContext::pipeline(const FaceState& state) {
  pipeline_.setState(state);
  checkOrThrow(pipeline_);
  updateOrThrow(pipeline_);
  return pipeline_;
}

FaceCurves FigureContext::curves(const FaceState& state) {
  FaceCurves face;
  pipeline_.setState(state);
  checkOrThrow(pipeline_);
  std::string fault = pipeline_.updateCurves();  // no surface is needed
  auto* const curves = vtkPolyData::SafeDownCast(pipeline_.shownCurves()->GetOutputDataObject(0));
  if (fault.empty()) fault = readFaceCurves(curves, face);
  if (!fault.empty()) throw FileFailure(fault);
  return face;
}

QImage FigureContext::imageOf(vtkImageData* picture) {
  const int* const size = picture->GetDimensions();
  const int components = picture->GetNumberOfScalarComponents();
  const auto* const pixels = static_cast<const uchar*>(picture->GetScalarPointer());
  const QImage shared(pixels, size[0], size[1], components * size[0],
                      components == 4 ? QImage::Format_RGBA8888 : QImage::Format_RGB888);
  return shared.mirrored();
}

FaceCurves FigureContext::neutralFace() {
  return curves(FaceMotion::neutralOf(state_));
}

vtkPolyData* FigureContext::neutralCurves(const FaceState& state) {
  return pipeline(state).neutralCurves()->GetOutput();
}

void FigureContext::requireDisplay() {
  if (!display_) display_.emplace();
}

/// All figures show one neutral face, onto which each photograph is warped once.
vtkSmartPointer<vtkImageData> FigureContext::textureOf(FacePipeline& pipeline) {
  const FaceState& state = pipeline.state();
  if (state.texture.empty()) return nullptr;
  vtkSmartPointer<vtkImageData>& texture = warped_[{state.texture, state.textureMesh}];
  if (!texture) texture = faceTexture(pipeline);
  return texture;
}

QImage FigureContext::picture(const FaceState& state, SceneStyle style, double width, double shape,
                              vtkPolyData* framed) {
  requireDisplay();
  style.width = pixelsOf(width, settings_.dotsPerInch);
  style.height = pixelsOf(width * shape, settings_.dotsPerInch);
  style.transparent = true;
  FacePipeline& face = pipeline(state);
  FaceScene scene(face, style, textureOf(face));
  if (framed) scene.placeCamera(framed);
  return imageOf(scene.render());
}

PlatePanel FigureContext::facePanel(const std::string& heading, const FaceState& state, const SceneStyle& style,
                                    double width, double shape) {
  return picturePanel(heading, picture(state, style, width, shape));
}

std::vector<PlatePanel> FigureContext::facePanels(const std::vector<NamedFace>& faces, const SceneStyle& style,
                                                  double width, double shape) {
  OutermostPoints together(style.view);
  for (const NamedFace& face : faces) {
    FacePipeline& moved = pipeline(face.state);
    together.add(vtkPolyData::SafeDownCast(moved.surface()->GetOutputDataObject(0))->GetPoints());
  }
  std::vector<PlatePanel> panels;
  for (const NamedFace& face : faces)
    panels.push_back(picturePanel(face.heading, picture(face.state, style, width, shape, together.points())));
  return panels;
}

MotionField FigureContext::motion(const FaceState& moved, const FaceState& origin) {
  FaceMotion motion;
  motion.setStates(moved, origin);
  checkOrThrow(motion.moved());
  checkOrThrow(motion.origin());
  const std::string fault = motion.update();
  if (!fault.empty()) throw FileFailure(fault);
  return motion.field();
}

MotionVectorOptions FigureContext::vectorOptions() const {
  MotionVectorOptions options;
  options.theme = settings_.theme.name;
  options.picture.sampling.kind = VectorSampling::Kind::Automatic;
  return options;
}

FaceState FigureContext::textured(FaceState state, size_t texture) const {
  const std::vector<std::string>& files = settings_.textures;
  state.textureMesh.clear();
  setTexture(texture < files.size() ? files[texture] : "painted", state);
  return state;
}

double FigureContext::innerWidth() const {
  return PlatePainter::panelWidth(settings_.width, 1, 1);
}

template <class Words>
void FigureContext::keepWords(Words& words, FigureDrawing& drawing) const {
  if (words.note.empty()) words.note = showsFace_ ? faceNote(state_, {state_.surface.scheme}) : "Mien " MIEN_VERSION;
  drawing.caption = words.caption;
  drawing.note = words.note;
  if (settings_.captioned) return;
  words.title.clear();
  words.caption.clear();
  words.note.clear();
}

FigureDrawing FigureContext::drawn(Plate plate, bool labelled) const {
  FigureDrawing drawing;
  keepWords(plate, drawing);
  const auto painter =
      std::make_shared<PlatePainter>(plate, settings_.theme, settings_.width, labelled && settings_.labelled);
  drawing.size = painter->size();
  drawing.paint = [painter](QPainter& p) { painter->paint(p); };
  return drawing;
}

FigureDrawing FigureContext::drawn(Figure figure) const {
  FigureDrawing drawing;
  keepWords(figure, drawing);
  figure.labelled = figure.labelled && settings_.labelled;
  const auto painter = std::make_shared<FigurePainter>(figure, settings_.theme, settings_.width);
  drawing.size = painter->size();
  drawing.paint = [painter](QPainter& p) { painter->paint(p); };
  return drawing;
}

}  // namespace mien
