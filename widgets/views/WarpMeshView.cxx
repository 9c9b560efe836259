#include "WarpMeshView.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QVariant>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "OwnKeys.h"
#include "Theme.h"

namespace mien {

namespace {

constexpr double graspReach = 12.0;                    // pixels from a point, for the mouse
constexpr double zoomStep = 1.25, largestZoom = 40.0;  // a notch of the wheel
constexpr double notch = 120.0;                        // of a wheel, as Qt counts
constexpr double warpPointSize = 3.5, smallPointSize = 2.0, chosenSize = 6.0;
constexpr int manyPoints = 100;
constexpr double step = 1.0, largeStep = 10.0;  // pixels of the photograph, by an arrow key
const QColor meshLineColor("#ffd23f"), edgeColor("#1b2027"), chosenColor("#ff6a2b");

}  // namespace

WarpMeshView::WarpMeshView(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setProperty(ownKeys, QStringList{tr("Tab, Shift+Tab: the next point of the mesh, the one before"),
                                   tr("Arrow keys: one pixel, with Shift ten")});
  setMinimumSize(120, 100);
}

void WarpMeshView::setPicture(const QImage& picture) {
  if (picture.size() != picture_.size()) {
    zoom_ = 1.0;
    pan_ = {};
  }
  picture_ = picture;
  update();
}

void WarpMeshView::setMesh(const WarpMesh& mesh) {
  if (mesh.rows() != mesh_.rows() || mesh.columns() != mesh_.columns()) chosen_ = {mesh.rows() / 2, mesh.columns() / 2};
  mesh_ = mesh;
  emit chosenChanged();
  update();
}

void WarpMeshView::setFlagged(bool flagged) {
  flagged_ = flagged;
  update();
}

void WarpMeshView::setHint(const QString& hint) {
  hint_ = hint;
  update();
}

void WarpMeshView::choose(MeshNode node) {
  chosen_ = node;
  emit chosenChanged();
  update();
}

QTransform WarpMeshView::toWidget() const {
  const double fit = std::min(width() / mesh_.width, height() / mesh_.height) * zoom_;
  QTransform transform;
  transform.translate(0.5 * width() + pan_.x(), 0.5 * height() + pan_.y());
  transform.scale(fit, fit);
  transform.translate(-0.5 * mesh_.width, -0.5 * mesh_.height);
  return transform;
}

QPointF WarpMeshView::pixelOf(MeshNode node) const {
  return toWidget().map(QPointF(mesh_.x(node.row, node.column), mesh_.y(node.row, node.column)));
}

void WarpMeshView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Theme::current().viewBottom);
  if (isEmpty()) {
    painter.setPen(Theme::current().faintText);
    painter.drawText(rect().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap, hint_);
    return;
  }
  painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  painter.drawImage(toWidget().mapRect(QRectF(0.0, 0.0, mesh_.width, mesh_.height)), picture_);
  drawMesh(painter);
  drawPoints(painter);
  if (!hasFocus()) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(Theme::current().accent);
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

/// Light lines on dark ones are seen on any photograph.
void WarpMeshView::drawMesh(QPainter& painter) const {
  const bool fine = mesh_.rows() * mesh_.columns() > manyPoints;
  for (const bool edge : {true, false}) {
    QColor color = edge ? edgeColor : flagged_ ? Theme::current().error : meshLineColor;
    color.setAlphaF(edge ? 0.35 : 0.9);
    painter.setPen(QPen(color, (fine ? 0.8 : 1.2) + (edge ? 1.6 : 0.0)));
    for (int i = 0; i < mesh_.rows(); ++i)
      for (int j = 0; j < mesh_.columns(); ++j) {
        if (j > 0) painter.drawLine(pixelOf({i, j - 1}), pixelOf({i, j}));
        if (i > 0) painter.drawLine(pixelOf({i - 1, j}), pixelOf({i, j}));
      }
  }
}

void WarpMeshView::drawPoints(QPainter& painter) const {
  const double size = mesh_.rows() * mesh_.columns() > manyPoints ? smallPointSize : warpPointSize;
  painter.setPen(QPen(edgeColor, 1.0));
  painter.setBrush(flagged_ ? Theme::current().error : meshLineColor);
  for (int i = 0; i < mesh_.rows(); ++i)
    for (int j = 0; j < mesh_.columns(); ++j) painter.drawEllipse(pixelOf({i, j}), size, size);
  if (chosen_.row < 0) return;
  painter.setPen(QPen(Qt::white, 1.5));
  painter.setBrush(chosenColor);
  painter.drawEllipse(pixelOf(chosen_), chosenSize, chosenSize);
}

void WarpMeshView::mousePressEvent(QMouseEvent* event) {
  if (isEmpty()) return;
  const QTransform transform = toWidget();
  const QPointF place = transform.inverted().map(event->localPos());
  const MeshNode node = nearestNode(mesh_, place.x(), place.y(), graspReach / transform.m11());
  dragging_ = node.row >= 0 && event->button() == Qt::LeftButton;
  panning_ = !dragging_;
  grip_ = dragging_ ? pixelOf(node) - event->localPos() : event->localPos();
  if (dragging_) choose(node);
}

void WarpMeshView::mouseMoveEvent(QMouseEvent* event) {
  if (dragging_) {
    const QPointF place = toWidget().inverted().map(event->localPos() + grip_);
    emit dragged(chosen_, place.x(), place.y());
  }
  if (!panning_) return;
  pan_ += event->localPos() - grip_;
  grip_ = event->localPos();
  update();
}

void WarpMeshView::mouseReleaseEvent(QMouseEvent*) {
  if (dragging_) emit released();
  dragging_ = panning_ = false;
}

void WarpMeshView::mouseDoubleClickEvent(QMouseEvent*) {
  zoom_ = 1.0;
  pan_ = {};
  update();
}

/// What is below the mouse stays below it.
void WarpMeshView::wheelEvent(QWheelEvent* event) {
  if (isEmpty()) return;
  const double zoom = std::clamp(zoom_ * std::pow(zoomStep, event->angleDelta().y() / notch), 1.0, largestZoom);
  const QPointF middle(0.5 * width(), 0.5 * height()), from = event->position() - middle;
  pan_ = zoom > 1.0 ? from + (pan_ - from) * (zoom / zoom_) : QPointF();
  zoom_ = zoom;
  event->accept();
  update();
}

void WarpMeshView::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  const double length = event->modifiers() & Qt::ShiftModifier ? largeStep : step;
  const double dx = key == Qt::Key_Right ? length : key == Qt::Key_Left ? -length : 0.0;
  const double dy = key == Qt::Key_Down ? length : key == Qt::Key_Up ? -length : 0.0;
  if (isEmpty() || chosen_.row < 0 || (dx == 0.0 && dy == 0.0)) return QWidget::keyPressEvent(event);
  emit dragged(chosen_, mesh_.x(chosen_.row, chosen_.column) + dx, mesh_.y(chosen_.row, chosen_.column) + dy);
}

/// A key that is held down makes one step of undo.
void WarpMeshView::keyReleaseEvent(QKeyEvent* event) {
  if (!event->isAutoRepeat()) emit released();
  QWidget::keyReleaseEvent(event);
}

/// Tab goes from point to point, and on to the next control after the last.
bool WarpMeshView::focusNextPrevChild(bool next) {
  const int columns = std::max(1, mesh_.columns()), count = mesh_.rows() * mesh_.columns();
  const int index = chosen_.row * columns + chosen_.column + (next ? 1 : -1);
  if (isEmpty() || index < 0 || index >= count) return QWidget::focusNextPrevChild(next);
  choose({index / columns, index % columns});
  return true;
}

}  // namespace mien
