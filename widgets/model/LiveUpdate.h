#pragma once

#include <QObject>
#include <functional>

class QTimer;
class QWidget;

namespace mien {

class FaceModel;

/// Keeps a dock up to date with the face: at most once in an interval while sliders move, and not at all while nobody
/// sees the dock or what it shows on the face.
class LiveUpdate : public QObject {
  Q_OBJECT
 public:
  /// @param isOnFace  whether the dock shows something on the face, which is seen without the dock too
  LiveUpdate(FaceModel* model, QWidget* dock, std::function<void()> refresh, std::function<bool()> isOnFace = {});

 public slots:
  void request();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void run();
  bool isSeen() const;

  QWidget* dock_;
  std::function<void()> refresh_;
  std::function<bool()> isOnFace_;
  QTimer* timer_;
  bool outdated_ = true;
};

}  // namespace mien
