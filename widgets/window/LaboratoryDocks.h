#pragma once

#include <QObject>

class QDockWidget;
class QMainWindow;

namespace mien {

class AnimationPlayer;
class CurveView;
class FaceModel;
class FaceView;
class TimelinePanel;
class ViewFrame;

/// The docks of the animation and of the surface laboratory, in tabs below the face; closed until they are asked for.
class LaboratoryDocks : public QObject {
  Q_OBJECT
 public:
  LaboratoryDocks(FaceModel* model, AnimationPlayer* player, FaceView* view, CurveView* curves, QMainWindow* window);

  /// A button in the head of the face that brings the plain skin back.
  void addSkinButton(ViewFrame* frame);

  /// A switch in the head of the face for a scan over it, while one is open.
  void addScanSwitch(ViewFrame* frame);

  /// A button in the timeline that opens and closes the plot of the FAPs.
  void addPlotButton(TimelinePanel* timeline);

 private:
  QDockWidget* add(const QString& name, const QString& title, QWidget* panel);
  void giveHeight(QDockWidget* dock, bool hasPicture);

  FaceView* view_;
  QMainWindow* window_;
  QDockWidget *last_ = nullptr, *plot_;
};

}  // namespace mien
