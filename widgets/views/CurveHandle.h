#pragma once

#include <vtkNew.h>

#include <QObject>
#include <QPointF>
#include <array>

class QKeyEvent;
class QMouseEvent;
class vtkActor;
class vtkPolyData;
class vtkStaticCellLocator;
class vtkTextActor;

namespace mien {

class CurveView;
class FaceModel;

/// The point of a curve under the mouse, highlighted with its name, and dragged in the plane of the view with the left
/// button; Escape cancels a drag. What a drag does, its receiver says. Off until it is enabled.
class CurveHandle : public QObject {
  Q_OBJECT
 public:
  using Vector = std::array<double, 3>;

  CurveHandle(CurveView* view, FaceModel* model, QObject* parent);
  ~CurveHandle() override;

  void setEnabled(bool enabled);
  bool isShown() const { return index_ >= 0; }
  QString name() const;  ///< "C15, v 216.0 degrees" of the highlighted point; empty without one

  /// Where a point of the shown curves lies in the view, in the widget's pixels.
  QPointF pixelOf(int curve, int point) const;

 signals:
  void grabbed(int curve, int point);
  void dragged(const mien::CurveHandle::Vector& move);  ///< mm from where it was grabbed
  void cancelled();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool release(const QMouseEvent& event);
  bool cancel(const QKeyEvent& event);
  void choose(int index);
  void follow();
  void useTheme();
  vtkPolyData* curves() const;
  int indexAt(const QPointF& pixel);
  bool isHidden(const double point[3]);
  Vector inView(const double world[3]) const;
  Vector worldAt(const QPointF& pixel, double depth) const;

  CurveView* view_;
  FaceModel* model_;
  vtkNew<vtkActor> mark_;
  vtkNew<vtkTextActor> label_;
  vtkNew<vtkStaticCellLocator> skin_;
  bool enabled_ = false, dragging_ = false, outdated_ = true;
  int index_ = -1;     ///< of the point in the shown curves
  Vector grip_{};      ///< where the point was when it was grabbed, mm
  QPointF gripPixel_;  ///< where the mouse was
};

}  // namespace mien
