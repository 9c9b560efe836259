#include "CurveHandle.h"

#include <vtkActor.h>
#include <vtkAlgorithm.h>
#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkStaticCellLocator.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <QKeyEvent>
#include <QMouseEvent>
#include <cmath>

#include "CurveEdit.h"
#include "CurveView.h"
#include "FaceLayout.h"
#include "FaceModel.h"
#include "Theme.h"

namespace mien {

namespace {

constexpr double reach = 10.0;        // pixels from a point, for the mouse
constexpr double markRadius = 2.2;    // mm
constexpr double edgeWidth = 0.01;    // mm: a line between two polygons hits either
constexpr double onSkin = 6.0;        // mm by which a point may lie below the mesh, which cuts corners of its curves
constexpr double labelOffset = 12.0;  // pixels
constexpr int labelSize = 13;

}  // namespace

CurveHandle::CurveHandle(CurveView* view, FaceModel* model, QObject* parent)
    : QObject(parent), view_(view), model_(model) {
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(markRadius);
  ball->SetThetaResolution(16);
  ball->SetPhiResolution(16);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(ball->GetOutputPort());
  mark_->SetMapper(mapper);
  mark_->GetProperty()->LightingOff();
  mark_->VisibilityOff();
  label_->VisibilityOff();
  label_->GetTextProperty()->SetFontSize(labelSize);
  label_->GetTextProperty()->ShadowOff();
  view_->renderer()->AddActor(mark_);
  view_->renderer()->AddActor2D(label_);
  view_->installEventFilter(this);
  useTheme();
  connect(model_, &FaceModel::updated, this, [this] {
    outdated_ = true;
    follow();
  });
}

CurveHandle::~CurveHandle() = default;

void CurveHandle::setEnabled(bool enabled) {
  if (!enabled && dragging_) {
    dragging_ = false;
    emit cancelled();
  }
  enabled_ = enabled;
  if (!enabled) choose(-1);
}

vtkPolyData* CurveHandle::curves() const {
  return vtkPolyData::SafeDownCast(model_->pipeline().shownCurves()->GetOutputDataObject(0));
}

QString CurveHandle::name() const {
  if (index_ < 0) return {};
  const int count = model_->pointsPerCurve();
  const CurveEdit edit = CurveEdit::ofPoint(index_ / count, index_ % count, count);
  return tr("%1, v %2\u00b0")
      .arg(QString::fromStdString(FaceLayout::curveName(edit.curve)))
      .arg(edit.vDegrees(), 0, 'f', 1);
}

/// Pixels of the widget to the right and down, and the depth that worldAt() needs.
CurveHandle::Vector CurveHandle::inView(const double world[3]) const {
  vtkRenderer* renderer = view_->renderer();
  renderer->SetWorldPoint(world[0], world[1], world[2], 1.0);
  renderer->WorldToDisplay();
  const double* display = renderer->GetDisplayPoint();
  const double ratio = view_->devicePixelRatioF();
  return {display[0] / ratio, view_->height() - 1.0 - display[1] / ratio, display[2]};
}

CurveHandle::Vector CurveHandle::worldAt(const QPointF& pixel, double depth) const {
  vtkRenderer* renderer = view_->renderer();
  const double ratio = view_->devicePixelRatioF();
  renderer->SetDisplayPoint(ratio * pixel.x(), ratio * (view_->height() - 1.0 - pixel.y()), depth);
  renderer->DisplayToWorld();
  const double* world = renderer->GetWorldPoint();
  return {world[0] / world[3], world[1] / world[3], world[2] / world[3]};
}

QPointF CurveHandle::pixelOf(int curve, int point) const {
  const Vector place = inView(curves()->GetPoint(curve * model_->pointsPerCurve() + point));
  return {place[0], place[1]};
}

bool CurveHandle::isHidden(const double point[3]) {
  if (outdated_) {
    skin_->SetDataSet(vtkPolyData::SafeDownCast(model_->pipeline().surface()->GetOutputDataObject(0)));
    skin_->Modified();
    skin_->BuildLocator();
    outdated_ = false;
  }
  double eye[3], t, hit[3], shares[3];
  int part;
  vtkIdType cell;
  view_->camera()->GetPosition(eye);
  if (skin_->IntersectWithLine(eye, point, edgeWidth, t, hit, shares, part, cell) == 0) return false;
  return std::sqrt(vtkMath::Distance2BetweenPoints(hit, point)) > onSkin;
}

int CurveHandle::indexAt(const QPointF& pixel) {
  vtkPolyData* all = curves();
  int nearest = -1;
  double least = reach;
  for (vtkIdType i = 0; all && i < all->GetNumberOfPoints(); ++i) {
    double point[3];
    all->GetPoint(i, point);
    const Vector place = inView(point);
    const double distance = std::hypot(place[0] - pixel.x(), place[1] - pixel.y());
    if (distance >= least || isHidden(point)) continue;
    least = distance;
    nearest = static_cast<int>(i);
  }
  return nearest;
}

void CurveHandle::choose(int index) {
  if (index == index_) return;
  index_ = index;
  mark_->SetVisibility(index >= 0);
  label_->SetVisibility(index >= 0);
  index >= 0 ? view_->setCursor(Qt::OpenHandCursor) : view_->unsetCursor();
  follow();
  view_->redraw();
}

/// The mark stays on its point while the face moves.
void CurveHandle::follow() {
  vtkPolyData* all = curves();
  if (index_ < 0) return;
  if (!all || index_ >= all->GetNumberOfPoints()) return choose(-1);
  double point[3];
  all->GetPoint(index_, point);
  mark_->SetPosition(point);
  const Vector place = inView(point);
  const double ratio = view_->devicePixelRatioF();
  label_->SetInput(name().toUtf8().constData());
  label_->SetDisplayPosition(static_cast<int>(ratio * (place[0] + labelOffset)),
                             static_cast<int>(ratio * (view_->height() - 1.0 - place[1] + labelOffset)));
}

bool CurveHandle::press(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton) return dragging_;
  choose(indexAt(event.localPos()));
  if (index_ < 0) return false;
  curves()->GetPoint(index_, grip_.data());
  gripPixel_ = event.localPos();
  dragging_ = true;
  view_->setFocus();
  view_->setCursor(Qt::ClosedHandCursor);
  emit grabbed(index_ / model_->pointsPerCurve(), index_ % model_->pointsPerCurve());
  return true;
}

/// The depth is asked for anew, as it follows the planes between which the view draws.
bool CurveHandle::move(const QMouseEvent& event) {
  if (!dragging_) {
    if (event.buttons() == Qt::NoButton) choose(indexAt(event.localPos()));
    return false;
  }
  const double depth = inView(grip_.data())[2];
  const Vector from = worldAt(gripPixel_, depth), to = worldAt(event.localPos(), depth);
  emit dragged({to[0] - from[0], to[1] - from[1], to[2] - from[2]});
  return true;
}

bool CurveHandle::release(const QMouseEvent& event) {
  if (!dragging_) return false;
  if (event.button() == Qt::LeftButton) {
    dragging_ = false;
    view_->setCursor(Qt::OpenHandCursor);
  }
  return true;
}

bool CurveHandle::cancel(const QKeyEvent& event) {
  if (!dragging_ || event.key() != Qt::Key_Escape) return false;
  dragging_ = false;
  emit cancelled();
  return true;
}

bool CurveHandle::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::PaletteChange) useTheme();
  if (!enabled_) return QObject::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      return press(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseMove:
      return move(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonRelease:
      return release(*static_cast<QMouseEvent*>(event));
    case QEvent::KeyPress:
      return cancel(*static_cast<QKeyEvent*>(event));
    case QEvent::MouseButtonDblClick:
    case QEvent::Wheel:
      return dragging_ || (event->type() == QEvent::MouseButtonDblClick && index_ >= 0);
    case QEvent::Leave:
      if (!dragging_) choose(-1);
      return false;
    default:
      return false;
  }
}

void CurveHandle::useTheme() {
  const Theme& theme = Theme::current();
  mark_->GetProperty()->SetColor(theme.accent.redF(), theme.accent.greenF(), theme.accent.blueF());
  label_->GetTextProperty()->SetColor(theme.text.redF(), theme.text.greenF(), theme.text.blueF());
}

}  // namespace mien
