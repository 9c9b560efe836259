#pragma once

#include <QFrame>

class QComboBox;
class QHBoxLayout;
class QLabel;
class QToolButton;

namespace mien {

class AnimationPlayer;
class ValueSlider;
class FaceModel;
class FrameBox;

/// Where in the animation are we? Play, pause, scrub and loop a .fap file or a range of it, at any speed, with or
/// without pictures between its frames. Without an animation it is one slim line that says how to get one.
class TimelinePanel : public QFrame {
  Q_OBJECT
 public:
  TimelinePanel(FaceModel* model, AnimationPlayer* player, QWidget* parent = nullptr);

  /// Adds a button for what belongs to the timeline, at its right end.
  void addButton(QToolButton* button);

 signals:
  void openRequested();
  void demonstrationRequested();

 private:
  void buildButtons();
  void buildPosition();
  void buildRange();
  void buildSpeed();
  void connectRange();
  void connectAll();
  void showAnimation();  ///< another file
  void showFrame();      ///< another frame
  void showRange();
  void showPlaying(bool playing);

  FaceModel* model_;
  AnimationPlayer* player_;
  QToolButton *open_, *first_, *play_, *loop_, *close_, *in_, *out_, *smooth_, *demonstration_;
  QComboBox* speed_;
  ValueSlider* position_;
  FrameBox* frame_;
  QLabel *title_, *time_, *rate_;
  QWidget* deck_;
  QHBoxLayout* lower_;
};

}  // namespace mien
