#pragma once

#include <QImage>
#include <QTransform>
#include <QWidget>

#include "WarpMeshEdit.h"

namespace mien {

/// A photograph with its mesh drawn over it. Points are dragged with the mouse, or chosen with Tab and moved with the
/// arrow keys by one pixel of the photograph (ten with Shift); the wheel zooms, a drag beside the points pans, a double
/// click shows all again.
class WarpMeshView : public QWidget {
  Q_OBJECT
 public:
  explicit WarpMeshView(QWidget* parent = nullptr);

  void setPicture(const QImage& picture);
  void setMesh(const WarpMesh& mesh);
  void setFlagged(bool flagged);      ///< whether the mesh is drawn as one that cannot be used
  void setHint(const QString& hint);  ///< what is said while there is no picture

  MeshNode chosen() const { return chosen_; }
  void choose(MeshNode node);
  QPointF pixelOf(MeshNode node) const;  ///< where a point of the mesh is on this widget

 signals:
  void chosenChanged();
  void dragged(MeshNode node, double x, double y);  ///< to a place in pixels of the photograph
  void released();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  bool focusNextPrevChild(bool next) override;
  QSize sizeHint() const override { return {300, 240}; }

 private:
  QTransform toWidget() const;  ///< from pixels of the photograph
  void drawMesh(QPainter& painter) const;
  void drawPoints(QPainter& painter) const;
  bool isEmpty() const { return picture_.isNull() || mesh_.rows() == 0; }

  QImage picture_;
  WarpMesh mesh_;
  MeshNode chosen_;
  QString hint_;
  double zoom_ = 1.0;
  QPointF pan_;   ///< of the middle, pixels of the widget
  QPointF grip_;  ///< from the mouse to the point that is dragged, or where a pan began
  bool dragging_ = false, panning_ = false, flagged_ = false;
};

}  // namespace mien
