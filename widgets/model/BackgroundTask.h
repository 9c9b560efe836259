#pragma once

#include <QObject>
#include <atomic>
#include <functional>
#include <thread>

namespace mien {

/// One piece of work at a time off the GUI thread: with progress, cancelled at any time, and harmless when its owner
/// goes away.
///
/// VTK data that work takes along go into one std::shared_ptr: to let go of a data object of one's own is to walk all
/// that it leads to (vtkGarbageCollector), the filters of the other thread among them.
class BackgroundTask : public QObject {
  Q_OBJECT
 public:
  /// Told the share that is done (0 .. 1); false when the work should end.
  using Progress = std::function<bool(double share)>;
  /// Runs on a thread of its own; what it returns is called on the GUI thread, unless it was cancelled.
  using Work = std::function<std::function<void()>(const Progress&)>;

  explicit BackgroundTask(QObject* parent) : QObject(parent) {}
  ~BackgroundTask() override;  ///< cancels and waits for the end of the present step

  enum class Before {
    Ends,     ///< work that is still going on is cancelled
    Finishes  ///< and delivered first; of several that wait only the last is done
  };

  void start(const Work& work, Before before = Before::Ends);
  void cancel();
  bool isRunning() const { return running_; }

 signals:
  void progressed(int percent);
  void runningChanged(bool running);

 private:
  void launch(const Work& work);
  void end(const std::function<void()>& deliver);

  std::thread thread_;
  std::atomic<bool> cancelled_{false};
  bool running_ = false;
  Work next_;
};

}  // namespace mien
