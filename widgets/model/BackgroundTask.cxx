#include "BackgroundTask.h"

namespace mien {

BackgroundTask::~BackgroundTask() {
  cancelled_ = true;
  if (thread_.joinable()) thread_.join();
}

/// The window does not wait for the old work's present step: the new one begins when it has ended.
void BackgroundTask::start(const Work& work, Before before) {
  if (!running_) return launch(work);
  if (before == Before::Ends) cancelled_ = true;
  next_ = work;
}

void BackgroundTask::cancel() {
  cancelled_ = true;
  next_ = nullptr;
}

void BackgroundTask::launch(const Work& work) {
  if (thread_.joinable()) thread_.join();
  cancelled_ = false;
  const bool begins = !running_;
  running_ = true;
  if (begins) emit runningChanged(true);
  thread_ = std::thread([this, work] {
    const std::function<void()> deliver = work([this](double share) {
      QMetaObject::invokeMethod(
          this, [this, share] { emit progressed(static_cast<int>(100.0 * share)); }, Qt::QueuedConnection);
      return !cancelled_;
    });
    QMetaObject::invokeMethod(
        this, [this, deliver] { end(deliver); }, Qt::QueuedConnection);
  });
}

void BackgroundTask::end(const std::function<void()>& deliver) {
  thread_.join();
  if (!cancelled_ && deliver) deliver();
  if (next_) {
    const Work work = next_;
    next_ = nullptr;
    return launch(work);
  }
  running_ = false;
  emit runningChanged(false);
}

}  // namespace mien
