#pragma once

#include <QFrame>

class QLabel;
class QSpinBox;
class QToolButton;

namespace mien {

class AnimationPlayer;
class ValueSlider;
class FaceModel;

/// Where in the animation are we? Play, pause, scrub and loop a .fap file.
class TimelinePanel : public QFrame {
  Q_OBJECT
 public:
  TimelinePanel(FaceModel* model, AnimationPlayer* player, QWidget* parent = nullptr);

 signals:
  void openRequested();

 private:
  void buildButtons();
  void buildPosition();
  void connectAll();
  void showAnimation();  ///< another file
  void showFrame();      ///< another frame
  void showPlaying(bool playing);

  FaceModel* model_;
  AnimationPlayer* player_;
  QToolButton *open_, *first_, *play_, *loop_, *close_;
  ValueSlider* position_;
  QSpinBox* frame_;
  QLabel *title_, *time_;
};

}  // namespace mien
