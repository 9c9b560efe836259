#include "AnimationPlayer.h"

#include "FaceModel.h"

#include <QTimer>

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

constexpr int shortestWait = 4, longestWait = 200;  // ms; the longest keeps slow files responsive

}  // namespace

AnimationPlayer::AnimationPlayer(FaceModel* model, QObject* parent)
    : QObject(parent), model_(model), timer_(new QTimer(this)) {
  timer_->setTimerType(Qt::PreciseTimer);
  timer_->setSingleShot(true);
  connect(timer_, &QTimer::timeout, this, &AnimationPlayer::tick);
  connect(model_, &FaceModel::animationChanged, this, &AnimationPlayer::pause);
}

void AnimationPlayer::play() {
  if (playing_ || model_->frameCount() < 2) return;
  const bool atEnd = model_->frameIndex() + 1 >= model_->frameCount();
  playing_ = true;
  start(atEnd ? 0 : model_->frameIndex());
  emit playingChanged(true);
}

void AnimationPlayer::pause() {
  timer_->stop();
  if (!playing_) return;
  playing_ = false;
  emit playingChanged(false);
}

void AnimationPlayer::seek(int frame) {
  playing_ ? start(frame) : model_->showFrame(frame);
}

void AnimationPlayer::start(int frame) {
  firstFrame_ = frame;
  clock_.start();
  model_->showFrame(frame);
  timer_->start(shortestWait);
}

void AnimationPlayer::tick() {
  const double rate = model_->framesPerSecond();
  const double passed = clock_.nsecsElapsed() * 1e-9 * rate;  // frames
  const double frame = firstFrame_ + std::floor(passed);
  if (frame >= model_->frameCount() && loops_) return start(0);
  model_->showFrame(static_cast<int>(std::min(frame, model_->frameCount() - 1.0)));
  if (frame >= model_->frameCount()) return pause();
  const double wait = 1000.0 * (std::floor(passed) + 1.0 - passed) / rate;
  timer_->start(std::clamp(static_cast<int>(std::ceil(wait)), shortestWait, longestWait));
}

}  // namespace mien
