#include "RenderView.h"

#include <vtkBoundaryCurveReader.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkLight.h>
#include <vtkMath.h>
#include <vtkPolyData.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <QKeyEvent>
#include <QVariant>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "FaceModel.h"
#include "FaceOutline.h"
#include "OwnKeys.h"
#include "Theme.h"

namespace mien {

namespace {

constexpr double keyTurn = 5.0, keyZoom = 1.1;  // degrees and factor of a key
constexpr double viewAngle = 14.0;              // degrees: a portrait lens, nearly parallel
constexpr int settlingRounds = 3;

double degrees(RenderView::Side side) {
  return side == RenderView::Side::Front ? 0.0 : side == RenderView::Side::FortyFive ? 45.0 : 90.0;
}

constexpr const char* sideNames[] = {"front", "45", "side"};

nlohmann::json listOf(const double* vector) {
  return {vector[0], vector[1], vector[2]};
}

std::optional<std::array<double, 3>> vectorIn(const nlohmann::json& state, const char* name) {
  const auto list = state.find(name);
  if (list == state.end() || !list->is_array() || list->size() != 3) return {};
  for (const auto& value : *list)
    if (!value.is_number()) return {};
  return list->get<std::array<double, 3>>();
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
  setProperty(ownKeys, QStringList{tr("Arrow keys: turn the face or its curves by 5\u00b0"),
                                   tr("+, \u2212: nearer, further"), tr("Home: all of it")});
  window_->SetMultiSamples(0);
  renderer_->UseFXAAOn();  // smooth edges at a fraction of what samples cost without a graphics card
  window_->AddRenderer(renderer_);
  addLights();
  observeMouse();
  setBackground(renderer_, Theme::current());
  connect(model, &FaceModel::updated, this, &RenderView::redraw);
  connect(model, &FaceModel::reachChanged, this, &RenderView::followReach);
}

RenderView::~RenderView() = default;

/// Key from the upper left, fill from the right, rim from behind.
void RenderView::addLights() {
  renderer_->AutomaticLightCreationOff();
  renderer_->AddLight(cameraLight(-0.6, 0.75, 1.0, 0.72, 0.05));
  renderer_->AddLight(cameraLight(1.0, 0.1, 0.8, 0.42, -0.04));
  renderer_->AddLight(cameraLight(0.5, 0.9, -0.9, 0.25, 0.0));
  renderer_->AddLight(cameraLight(0.0, -0.4, 1.0, 0.16, 0.0));
}

void RenderView::observeMouse() {
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  interactor()->SetInteractorStyle(style);
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(this);
  observer->SetCallback(
      [](vtkObject*, unsigned long, void* view, void*) { static_cast<RenderView*>(view)->userMoved(); });
  style->AddObserver(vtkCommand::InteractionEvent, observer);
  style->AddObserver(vtkCommand::EndInteractionEvent, observer);
}

void RenderView::userMoved() {
  moved_ = true;
  passCamera();
  emit cameraMoved();
}

void RenderView::passCamera(const RenderView* except) {
  for (const QPointer<RenderView>& partner : partners_)
    if (partner && partner != except) partner->takeCamera(this);
}

/// A camera that the user has placed stays.
void RenderView::followReach() {
  if (moved_) return;
  placeCamera();
  if (!leader_) passCamera();
  redraw();
}

void RenderView::look(Side side) {
  side_ = side;
  fit();
}

void RenderView::fit() {
  moved_ = false;
  placeCamera();
  passCamera();
  redraw();
  emit cameraMoved();
}

void RenderView::placeCamera(const std::array<double, 3>& focus, const std::array<double, 3>& direction,
                             double distance) {
  camera()->SetFocalPoint(focus.data());
  camera()->SetPosition(focus[0] + distance * direction[0], focus[1] + distance * direction[1],
                        focus[2] + distance * direction[2]);
  camera()->SetViewUp(0.0, 1.0, 0.0);
  userMoved();
  redraw();
}

void RenderView::setCompany(const double* bounds) {
  setCompany(bounds ? cornersAround(bounds) : SeenPoints(), 0);
}

void RenderView::setCompany(const std::vector<std::array<double, 3>>& points, int margin) {
  company_ = points;
  companyMargin_ = margin;
}

void RenderView::setFoot(int pixels) {
  if (pixels == foot_) return;
  foot_ = pixels;
  raiseCentre();
  if (!moved_) placeCamera();
  redraw();
}

int RenderView::freeHeight() const {
  return std::max(1, height() - foot_);
}

/// What the camera looks at stands in the middle of what is above the foot.
void RenderView::raiseCentre() {
  camera()->SetWindowCenter(0.0, -static_cast<double>(foot_) / std::max(1, height()));
}

bool RenderView::hasTwin() const {
  return twin_ && twin_->isVisibleTo(twin_->window());
}

/// Twins show all of it in the smaller of them.
double RenderView::millimetresPerPixel(double width, double height) const {
  const auto perPixel = [&](const RenderView& view) {
    return std::max(width / std::max(1, view.width()), height / view.freeHeight());
  };
  return hasTwin() ? std::max(perPixel(*this), perPixel(*twin_)) : perPixel(*this);
}

double RenderView::distanceTo(double width, double height) const {
  return 0.5 * millimetresPerPixel(width, height) * std::max(1, this->height()) / std::tan(viewAngle * M_PI / 360.0);
}

const RenderView& RenderView::leader() const {
  return leader_ ? leader_->leader() : *this;
}

/// The distance decides how large near points look, and they decide the distance: it settles in few rounds.
std::array<double, 4> RenderView::fittingBox() const {
  const FaceModel& face = *leader().model_;
  const ViewAxes axes(degrees(side_));
  FaceOutline outline = restingOutline(axes, face);
  for (int round = 0; round < settlingRounds; ++round)
    outline = outlineOf(axes, face, outline, distanceTo(outline.size(0), outline.size(1)));
  return {outline.low[0], outline.high[0], outline.low[1], outline.high[1]};
}

double RenderView::fittingDistance() const {
  const auto [left, right, low, high] = fittingBox();
  return distanceTo(right - left, high - low);
}

/// Its margin makes the picture of all the rest smaller, and pixels larger: once more is near enough.
void RenderView::addCompany(const ViewAxes& axes, FaceOutline& outline) const {
  const RenderView& lead = leader();
  FaceOutline all = outline;
  for (int round = 0; round < 2; ++round) {
    const double pixel = millimetresPerPixel(all.size(0), all.size(1));
    all = outline;
    for (const RenderView* view : std::initializer_list<const RenderView*>{&lead, lead.twin_})
      for (const auto& point : view ? view->company_ : SeenPoints())
        all.add(axes, point.data(), view->companyMargin_ * pixel);
  }
  outline = all;
}

/// In depth the camera keeps to the face, whatever is shown with it. Linked views are of one scale, whatever each
/// shows.
void RenderView::placeCamera() {
  const RenderView& lead = leader();
  const ViewAxes axes(degrees(side_));
  FaceOutline outline = restingOutline(axes, *lead.model_);
  const double depth = outline.middle(2);
  const auto [left, right, low, high] = fittingBox();
  outline.add(0, left), outline.add(0, right);
  outline.add(1, low), outline.add(1, high);
  addCompany(axes, outline);
  const double distance = distanceTo(outline.size(0), outline.size(1));
  double focus[3], position[3];
  for (int i = 0; i < 3; ++i) {
    focus[i] = axes.right[i] * outline.middle(0) + axes.up[i] * outline.middle(1) + axes.out[i] * depth;
    position[i] = focus[i] + distance * axes.out[i];
  }
  camera()->SetViewAngle(viewAngle);
  camera()->SetFocalPoint(focus);
  camera()->SetPosition(position);
  camera()->SetViewUp(axes.up);
}

/// The same direction and, for the size of this view, the same zoom.
void RenderView::takeCamera(const RenderView* other) {
  side_ = other->side_;
  moved_ = other->moved_;
  const double ratio = fittingDistance() / other->fittingDistance();
  double focus[3], position[3];
  other->camera()->GetFocalPoint(focus);
  other->camera()->GetPosition(position);
  for (int i = 0; i < 3; ++i) position[i] = focus[i] + ratio * (position[i] - focus[i]);
  camera()->SetViewAngle(other->camera()->GetViewAngle());
  camera()->SetFocalPoint(focus);
  camera()->SetPosition(position);
  camera()->SetViewUp(other->camera()->GetViewUp());
  redraw();
  passCamera(other);
}

void RenderView::link(RenderView* other, Zoom zoom) {
  if (std::find(partners_.begin(), partners_.end(), other) != partners_.end()) return;
  leader_ = other;
  if (zoom == Zoom::ToScale) {
    twin_ = other;
    other->twin_ = this;
  }
  takeCamera(other);
  partners_.emplace_back(other);
  other->partners_.emplace_back(this);
}

void RenderView::unlink() {
  for (const QPointer<RenderView>& partner : partners_)
    if (partner) partner->forget(this);
  partners_.clear();
  leader_ = twin_ = nullptr;
}

void RenderView::forget(const RenderView* other) {
  if (leader_ == other) leader_ = nullptr;
  if (twin_ == other) twin_ = nullptr;
  partners_.erase(std::remove(partners_.begin(), partners_.end(), other), partners_.end());
}

vtkCamera* RenderView::camera() const {
  return renderer_->GetActiveCamera();
}

nlohmann::json RenderView::sessionState() const {
  nlohmann::json state = {{"side", sideNames[static_cast<int>(side_)]}};
  if (!moved_) return state;
  state["position"] = listOf(camera()->GetPosition());
  state["focus"] = listOf(camera()->GetFocalPoint());
  state["up"] = listOf(camera()->GetViewUp());
  return state;
}

/// Each view for itself, as a linked one has been kept too.
void RenderView::restoreSession(const nlohmann::json& state) {
  if (!state.is_object()) return;
  const auto name = state.find("side");
  for (Side side : {Side::Front, Side::FortyFive, Side::Profile})
    if (name != state.end() && *name == sideNames[static_cast<int>(side)]) side_ = side;
  moved_ = false;
  placeCamera();
  const auto position = vectorIn(state, "position"), focus = vectorIn(state, "focus"), up = vectorIn(state, "up");
  moved_ = position && focus && up && *position != *focus;
  if (moved_) {
    camera()->SetPosition(position->data());
    camera()->SetFocalPoint(focus->data());
    camera()->SetViewUp(up->data());
  }
  redraw();
}

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
  raiseCentre();
  if (moved_) return hasTwin() ? takeCamera(twin_) : void();
  placeCamera();  // not fit(): the other view has a size of its own
  redraw();
  if (!hasTwin() || twin_->moved_) return;
  twin_->placeCamera();
  twin_->redraw();
}

/// Turns and zooms as the mouse does.
bool RenderView::pressKey(int key) {
  const double aside = key == Qt::Key_Left ? keyTurn : key == Qt::Key_Right ? -keyTurn : 0.0;
  const double up = key == Qt::Key_Up ? keyTurn : key == Qt::Key_Down ? -keyTurn : 0.0;
  const double zoom = key == Qt::Key_Plus || key == Qt::Key_Equal ? keyZoom
                      : key == Qt::Key_Minus                      ? 1.0 / keyZoom
                                                                  : 1.0;
  if (key == Qt::Key_Home) fit();
  if (aside == 0.0 && up == 0.0 && zoom == 1.0) return key == Qt::Key_Home;
  camera()->Azimuth(aside);
  camera()->Elevation(-up);
  camera()->OrthogonalizeViewUp();
  camera()->Dolly(zoom);
  userMoved();
  redraw();
  return true;
}

/// Letters are not for VTK, where they would change how all is drawn.
bool RenderView::event(QEvent* event) {
  if (event->type() == QEvent::KeyPress)
    return pressKey(static_cast<QKeyEvent*>(event)->key()) || QOpenGLWidget::event(event);
  if (event->type() == QEvent::MouseButtonDblClick) {
    fit();
    return true;
  }
  return QVTKOpenGLNativeWidget::event(event);
}

}  // namespace mien
