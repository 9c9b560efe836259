#pragma once

#include <QObject>
#include <atomic>
#include <thread>
#include <vector>

#include "FAPFrame.h"

namespace mien {

class AnimationPlayer;
class FaceModel;

/// Shows a .fap stream while it is being written, such as standard input: always the newest frame, so that the face is
/// never late, whatever comes at once. Who goes back to an earlier frame, or plays, stays there until the newest is
/// shown again. A thread reads; it ends with the stream, a line that is wrong, another file or the object.
class LiveStream : public QObject {
  Q_OBJECT
 public:
  LiveStream(FaceModel* model, AnimationPlayer* player, int descriptor, QObject* parent = nullptr);
  ~LiveStream() override;

  bool isOpen() const { return open_; }

 signals:
  void failed(const QString& sentence, const QString& details);
  void ended(const QString& sentence, const QString& details);

 private:
  void read(int descriptor);
  void take(double framesPerSecond, const QString& name, const std::vector<FAPFrame>& frames);
  void finish(const QString& fault);

  FaceModel* model_;
  AnimationPlayer* player_;
  std::atomic<bool> stop_{false};
  bool open_ = true, started_ = false;
  std::thread thread_;  // last: it uses the others
};

}  // namespace mien
