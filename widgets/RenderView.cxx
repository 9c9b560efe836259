#include "RenderView.h"

#include "FaceModel.h"
#include "Theme.h"

#include <vtkBoundaryCurveReader.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkLight.h>
#include <vtkPolyData.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <QEvent>

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

constexpr double viewAngle = 14.0;  // degrees: a portrait lens, nearly parallel
constexpr double margin = 1.08;     // of the face's extent
constexpr int samples = 4;          // per pixel, for smooth edges

double degrees(RenderView::Side side) {
  return side == RenderView::Side::Front ? 0.0 : side == RenderView::Side::FortyFive ? 45.0 : 90.0;
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

void setBackground(vtkRenderer* renderer, const Theme& theme) {
  renderer->GradientBackgroundOn();
  renderer->SetBackground(theme.viewBottom.redF(), theme.viewBottom.greenF(), theme.viewBottom.blueF());
  renderer->SetBackground2(theme.viewTop.redF(), theme.viewTop.greenF(), theme.viewTop.blueF());
}

}  // namespace

RenderView::RenderView(FaceModel* model, QWidget* parent) : QVTKOpenGLNativeWidget(parent), model_(model) {
  setRenderWindow(window_);
  setAcceptDrops(false);  // the main window takes what is dropped
  setFocusPolicy(Qt::StrongFocus);
  window_->SetMultiSamples(samples);
  window_->AddRenderer(renderer_);
  addLights();
  observeMouse();
  setBackground(renderer_, Theme::current());
  connect(model, &FaceModel::updated, this, &RenderView::redraw);
}

RenderView::~RenderView() = default;

/// Key from the upper left, fill from the right, rim from behind.
void RenderView::addLights() {
  renderer_->AutomaticLightCreationOff();
  renderer_->AddLight(cameraLight(-0.75, 0.85, 1.0, 0.78, 0.06));
  renderer_->AddLight(cameraLight(1.0, 0.05, 0.8, 0.30, -0.04));
  renderer_->AddLight(cameraLight(0.5, 0.9, -0.9, 0.30, 0.0));
  renderer_->AddLight(cameraLight(0.0, -0.3, 1.0, 0.10, 0.0));
}

void RenderView::observeMouse() {
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  interactor()->SetInteractorStyle(style);
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(this);
  observer->SetCallback([](vtkObject*, unsigned long, void* view, void*) {
    auto* self = static_cast<RenderView*>(view);
    self->moved_ = true;
    emit self->cameraMoved();
  });
  style->AddObserver(vtkCommand::InteractionEvent, observer);
  style->AddObserver(vtkCommand::EndInteractionEvent, observer);
}

void RenderView::look(Side side) {
  side_ = side;
  fit();
}

void RenderView::fit() {
  moved_ = false;
  double b[6];
  vtkPolyData::SafeDownCast(model_->pipeline().neutralCurves()->GetOutputDataObject(0))->GetBounds(b);
  const double turn = degrees(side_) * M_PI / 180.0;
  const double out[3] = {std::sin(turn), 0.0, std::cos(turn)};
  const double breadth = (b[1] - b[0]) * std::abs(out[2]) + (b[5] - b[4]) * std::abs(out[0]);
  const double roundness = side_ == Side::FortyFive ? 0.85 : 1.0;  // the head does not fill its box's corners
  const double aspect = static_cast<double>(std::max(1, width())) / std::max(1, height());
  const double extent = margin * std::max(b[3] - b[2], roundness * breadth / aspect);
  const double nearness = 0.5 * ((b[5] - b[4]) * std::abs(out[2]) + (b[1] - b[0]) * std::abs(out[0]));
  const double distance = 0.5 * extent / std::tan(viewAngle * M_PI / 360.0) + 0.4 * nearness;
  vtkCamera* camera = renderer_->GetActiveCamera();
  camera->SetViewAngle(viewAngle);
  double focus[3];
  for (int i = 0; i < 3; ++i) focus[i] = 0.5 * (b[2 * i] + b[2 * i + 1]);
  camera->SetFocalPoint(focus);
  camera->SetPosition(focus[0] + distance * out[0], focus[1], focus[2] + distance * out[2]);
  camera->SetViewUp(0, 1, 0);
  redraw();
  emit cameraMoved();
}

void RenderView::share(vtkCamera* camera) {
  renderer_->SetActiveCamera(camera);
  redraw();
}

void RenderView::unshare() {
  vtkNew<vtkCamera> own;
  own->DeepCopy(renderer_->GetActiveCamera());
  renderer_->SetActiveCamera(own);
}

vtkCamera* RenderView::camera() const { return renderer_->GetActiveCamera(); }

void RenderView::redraw() {
  outdated_ = true;
  update();
}

void RenderView::paintGL() {
  if (outdated_) {
    outdated_ = false;
    renderer_->ResetCameraClippingRange();
    window_->Render();
  }
  QVTKOpenGLNativeWidget::paintGL();
}

void RenderView::useTheme() {
  setBackground(renderer_, Theme::current());
  redraw();
}

void RenderView::resizeEvent(QResizeEvent* event) {
  QVTKOpenGLNativeWidget::resizeEvent(event);
  if (!moved_) fit();
}

bool RenderView::event(QEvent* event) {
  if (event->type() == QEvent::MouseButtonDblClick) {
    fit();
    return true;
  }
  return QVTKOpenGLNativeWidget::event(event);
}

}  // namespace mien
