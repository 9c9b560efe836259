#pragma once

#include <QElapsedTimer>
#include <QObject>

#include "SessionPart.h"

class QTimer;

namespace mien {

class FaceModel;

/// Plays the model's animation, or a range of it, at the file's own rate or a multiple; frames that the computer is too
/// slow for are left out.
class AnimationPlayer : public QObject, public SessionPart {
  Q_OBJECT
 public:
  explicit AnimationPlayer(FaceModel* model, QObject* parent = nullptr);

  bool isPlaying() const { return playing_; }
  bool loops() const { return loops_; }
  int rangeBegin() const { return begin_; }  ///< first frame that is played, from 0
  int rangeEnd() const { return end_; }      ///< last frame that is played
  bool hasRange() const;                     ///< whether that is not all

  nlohmann::json sessionState() const override;  ///< `begin` and `end` of the range; {} without one
  QString changeName() const override { return tr("range to play"); }
  void restoreSession(const nlohmann::json& state) override;

 public slots:
  void play();  ///< from the current frame, or from the first of the range when that is its last or outside
  void pause();
  void setPlaying(bool playing) { playing ? play() : pause(); }
  void setLoop(bool loop) { loops_ = loop; }
  void seek(double frame);            ///< goes on from there while playing
  void setRange(int begin, int end);  ///< frames from 0, in either order; brought to the nearer end when outside
  void setSpeed(double speed);        ///< multiple of the file's rate, above 0; default 1

 signals:
  void playingChanged(bool playing);
  void rangeChanged();
  void rateMeasured(double framesPerSecond);  ///< of pictures shown, once a second while playing

 private:
  void tick();
  void start(double frame);
  void measureRate();
  void resetRange();
  void growRange();
  int waitFor(double position) const;

  FaceModel* model_;
  QTimer* timer_;
  QElapsedTimer clock_, rateClock_;
  double firstFrame_ = 0.0, speed_ = 1.0;
  int begin_ = 0, end_ = 0, shown_ = 0, known_ = 0;  ///< known_: frames of which the range is one
  bool playing_ = false, loops_ = true;
};

}  // namespace mien
