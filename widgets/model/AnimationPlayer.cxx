#include "AnimationPlayer.h"

#include <QTimer>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "FaceModel.h"

namespace mien {

namespace {

constexpr int shortestWait = 4, longestWait = 200;  // ms; the longest keeps slow files responsive
constexpr int smoothWait = 16;                      // between pictures that are mixed from two frames
constexpr int rateInterval = 1000;                  // ms

}  // namespace

AnimationPlayer::AnimationPlayer(FaceModel* model, QObject* parent)
    : QObject(parent), model_(model), timer_(new QTimer(this)) {
  setObjectName("animationPlayer");
  timer_->setTimerType(Qt::PreciseTimer);
  timer_->setSingleShot(true);
  connect(timer_, &QTimer::timeout, this, &AnimationPlayer::tick);
  connect(model_, &FaceModel::animationChanged, this, &AnimationPlayer::pause);
  connect(model_, &FaceModel::animationChanged, this, &AnimationPlayer::resetRange);
  connect(model_, &FaceModel::animationGrew, this, &AnimationPlayer::growRange);
  connect(model_, &FaceModel::updated, this, &AnimationPlayer::measureRate);
}

bool AnimationPlayer::hasRange() const {
  return begin_ > 0 || end_ + 1 < model_->frameCount();
}

void AnimationPlayer::resetRange() {
  setRange(0, model_->frameCount() - 1);
}

nlohmann::json AnimationPlayer::sessionState() const {
  if (!hasRange()) return nlohmann::json::object();
  return {{"begin", begin_}, {"end", end_}};
}

void AnimationPlayer::restoreSession(const nlohmann::json& state) {
  const auto frame = [&](const char* name, int otherwise) {
    const auto found = state.is_object() ? state.find(name) : state.end();
    return found != state.end() && found->is_number_integer() ? found->get<int>() : otherwise;
  };
  setRange(frame("begin", 0), frame("end", model_->frameCount() - 1));
}

/// An end that the user has set stays; one that is the animation's moves with it.
void AnimationPlayer::growRange() {
  setRange(begin_, end_ + 1 < known_ ? end_ : model_->frameCount() - 1);
}

void AnimationPlayer::setRange(int begin, int end) {
  known_ = model_->frameCount();
  const int last = std::max(0, known_ - 1);
  begin_ = std::clamp(std::min(begin, end), 0, last);
  end_ = std::clamp(std::max(begin, end), 0, last);
  emit rangeChanged();
}

void AnimationPlayer::setSpeed(double speed) {
  speed_ = speed;
  if (playing_) start(model_->framePosition());
}

void AnimationPlayer::play() {
  if (playing_ || end_ <= begin_) return;
  const double position = model_->framePosition();
  playing_ = true;
  shown_ = 0;
  rateClock_.start();
  start(position < begin_ || position >= end_ ? begin_ : position);
  emit playingChanged(true);
}

void AnimationPlayer::pause() {
  timer_->stop();
  if (!playing_) return;
  playing_ = false;
  emit playingChanged(false);
}

void AnimationPlayer::seek(double frame) {
  playing_ ? start(frame) : model_->showFrame(frame);
}

void AnimationPlayer::start(double frame) {
  firstFrame_ = frame;
  clock_.start();
  model_->showFrame(frame);
  timer_->start(shortestWait);
}

/// The last frame of the range is shown as long as any other.
void AnimationPlayer::tick() {
  const double position = firstFrame_ + clock_.nsecsElapsed() * 1e-9 * model_->framesPerSecond() * speed_;
  if (position >= end_ + 1.0 && loops_) return start(begin_);
  model_->showFrame(std::min<double>(position, end_));
  if (position >= end_ + 1.0) return pause();
  timer_->start(waitFor(position));
}

int AnimationPlayer::waitFor(double position) const {
  if (model_->interpolates()) return smoothWait;
  const double wait = 1000.0 * (std::floor(position) + 1.0 - position) / (model_->framesPerSecond() * speed_);
  return std::clamp(static_cast<int>(std::ceil(wait)), shortestWait, longestWait);
}

void AnimationPlayer::measureRate() {
  if (!playing_) return;
  ++shown_;
  const qint64 passed = rateClock_.elapsed();
  if (passed < rateInterval) return;
  emit rateMeasured(1000.0 * shown_ / passed);
  shown_ = 0;
  rateClock_.start();
}

}  // namespace mien
