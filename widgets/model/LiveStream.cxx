#include "LiveStream.h"

#include "AnimationPlayer.h"
#include "FAPLiveInput.h"
#include "FAPSequence.h"
#include "FaceModel.h"

namespace mien {

namespace {

constexpr int stopInterval = 100;  // ms until the thread looks whether it should stop

}  // namespace

LiveStream::LiveStream(FaceModel* model, AnimationPlayer* player, int descriptor, QObject* parent)
    : QObject(parent), model_(model), player_(player), thread_([this, descriptor] { read(descriptor); }) {}

LiveStream::~LiveStream() {
  stop_ = true;
  thread_.join();
}

/// On the thread. What it hands over is done by the GUI, and dropped when this object is gone.
void LiveStream::read(int descriptor) {
  FAPLiveInput input(descriptor);
  FAPLiveInput::State state = FAPLiveInput::State::Open;
  while (!stop_ && state == FAPLiveInput::State::Open) {
    std::vector<FAPFrame> frames;
    state = input.wait(stopInterval, frames);
    if (frames.empty()) continue;
    const double rate = input.sequence().framesPerSecond;
    const QString name = QString::fromStdString(input.sequence().name);
    QMetaObject::invokeMethod(
        this, [this, rate, name, frames] { take(rate, name, frames); }, Qt::QueuedConnection);
  }
  const QString fault = QString::fromStdString(input.fault());
  if (!stop_)
    QMetaObject::invokeMethod(
        this, [this, fault] { finish(fault); }, Qt::QueuedConnection);
}

void LiveStream::take(double framesPerSecond, const QString& name, const std::vector<FAPFrame>& frames) {
  if (!open_) return;
  if (started_ && !model_->isLive()) return finish({});  // another file has been opened, or none
  const bool follows = !started_ || (!player_->isPlaying() && model_->frameIndex() + 1 >= model_->frameCount());
  started_ = true;
  model_->appendLive(framesPerSecond, name, frames);
  if (follows) model_->showFrame(model_->frameCount() - 1);
}

void LiveStream::finish(const QString& fault) {
  if (!open_) return;
  open_ = false;
  stop_ = true;
  if (!fault.isEmpty())
    emit failed(fault, tr("The frames before it stay."));
  else if (model_->isLive())
    emit ended(tr("The stream has ended after %1 frames; Play shows them again.").arg(model_->frameCount()), {});
}

}  // namespace mien
