#include "LiveUpdate.h"

#include <QEvent>
#include <QTimer>
#include <QWidget>

#include "FaceModel.h"

namespace mien {

namespace {

constexpr int interval = 50;  // ms: quicker changes of numbers and charts cannot be read

}  // namespace

LiveUpdate::LiveUpdate(FaceModel* model, QWidget* dock, std::function<void()> refresh, std::function<bool()> isOnFace)
    : QObject(dock),
      dock_(dock),
      refresh_(std::move(refresh)),
      isOnFace_(std::move(isOnFace)),
      timer_(new QTimer(this)) {
  timer_->setSingleShot(true);
  timer_->setInterval(interval);
  connect(timer_, &QTimer::timeout, this, &LiveUpdate::run);
  connect(model, &FaceModel::updated, this, &LiveUpdate::request);
  dock_->installEventFilter(this);
}

bool LiveUpdate::isSeen() const {
  return dock_->isVisible() || (isOnFace_ && isOnFace_());
}

/// The timer is not started anew by every request, or a slider that moves all the time would put it off for ever.
void LiveUpdate::request() {
  outdated_ = true;
  if (isSeen() && !timer_->isActive()) timer_->start();
}

bool LiveUpdate::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Show && outdated_) timer_->start();
  return QObject::eventFilter(watched, event);
}

void LiveUpdate::run() {
  if (!isSeen()) return;
  outdated_ = false;
  refresh_();
}

}  // namespace mien
