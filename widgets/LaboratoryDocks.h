#pragma once

#include <QObject>

class QDockWidget;
class QMainWindow;

namespace mien {

class FaceModel;
class FaceView;
class ViewFrame;

/// The docks of the surface laboratory, in tabs below the face; closed until they are asked for in the View menu.
class LaboratoryDocks : public QObject {
  Q_OBJECT
 public:
  LaboratoryDocks(FaceModel* model, FaceView* view, QMainWindow* window);

  /// A button in the head of the face that brings the plain skin back.
  void addSkinButton(ViewFrame* frame);

 private:
  void add(const QString& name, const QString& title, QWidget* panel);

  FaceView* view_;
  QMainWindow* window_;
  QDockWidget* last_ = nullptr;
};

}  // namespace mien
