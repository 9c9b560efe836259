#pragma once

#include <QWidget>

#include "FaceView.h"

namespace mien {

class ColoringBar;
class CurveView;
class FaceModel;
class ViewFrame;

/// The views in the middle of the window, side by side: the face and its curves, and above them what the face shows.
class ViewArea : public QWidget {
  Q_OBJECT
 public:
  ViewArea(FaceModel* model, FaceView* face, CurveView* curves, QWidget* parent = nullptr);

  ViewFrame* faceFrame() const { return faceFrame_; }

  void look(RenderView::Side side);
  void useTheme();

 private:
  QWidget* displayRow();
  QWidget* splitter();
  void addMeshChoice();
  void addSideButtons();
  QWidget* curveFrame();
  void linkCameras(bool linked);
  void showWhole();

  FaceModel* model_;
  FaceView* face_;
  CurveView* curves_;
  ViewFrame* faceFrame_;
};

}  // namespace mien
