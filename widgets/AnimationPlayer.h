#pragma once

#include <QElapsedTimer>
#include <QObject>

class QTimer;

namespace mien {

class FaceModel;

/// Plays the model's animation at the file's own rate; frames that the computer is too slow for are left out.
class AnimationPlayer : public QObject {
  Q_OBJECT
 public:
  explicit AnimationPlayer(FaceModel* model, QObject* parent = nullptr);

  bool isPlaying() const { return playing_; }
  bool loops() const { return loops_; }

 public slots:
  void play();  ///< from the current frame, or from the first when the last is shown
  void pause();
  void setPlaying(bool playing) { playing ? play() : pause(); }
  void setLoop(bool loop) { loops_ = loop; }
  void seek(int frame);  ///< goes on from there while playing

 signals:
  void playingChanged(bool playing);

 private:
  void tick();
  void start(int frame);

  FaceModel* model_;
  QTimer* timer_;
  QElapsedTimer clock_;
  int firstFrame_ = 0;
  bool playing_ = false, loops_ = true;
};

}  // namespace mien
