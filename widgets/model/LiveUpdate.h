#pragma once

#include <QObject>
#include <functional>

class QTimer;
class QWidget;

namespace mien {

class FaceModel;

/// Keeps a dock up to date with the face: at most once in an interval while sliders move, and not at all while nobody
/// sees the dock.
class LiveUpdate : public QObject {
  Q_OBJECT
 public:
  LiveUpdate(FaceModel* model, QWidget* dock, std::function<void()> refresh);

 public slots:
  void request();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void run();

  QWidget* dock_;
  std::function<void()> refresh_;
  QTimer* timer_;
  bool outdated_ = true;
};

}  // namespace mien
