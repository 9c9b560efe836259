#pragma once

#include <QVTKOpenGLNativeWidget.h>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

class vtkCamera;
class vtkGenericOpenGLRenderWindow;
class vtkRenderer;

namespace mien {

class FaceModel;

/// A three-dimensional view of the face: light, background, camera and mouse. What is in it, its subclasses say.
///
/// The face fills the view until the user moves the camera; fit() goes back to that.
class RenderView : public QVTKOpenGLNativeWidget {
  Q_OBJECT
 public:
  enum class Side { Front, FortyFive, Profile };

  RenderView(FaceModel* model, QWidget* parent);
  ~RenderView() override;

  void look(Side side);
  void fit();  ///< the side looked from last, the whole face in the view

  void share(vtkCamera* camera);  ///< moves together with all views that share this camera
  void unshare();                 ///< goes on from here alone
  vtkCamera* camera() const;

  vtkRenderer* renderer() const { return renderer_; }
  void redraw();  ///< with the next paint event
  virtual void useTheme();  ///< takes the colours of the current theme

 signals:
  void cameraMoved();

 protected:
  void paintGL() override;
  void resizeEvent(QResizeEvent* event) override;
  bool event(QEvent* event) override;
  FaceModel& model() { return *model_; }

 private:
  void addLights();
  void observeMouse();

  FaceModel* model_;
  vtkNew<vtkGenericOpenGLRenderWindow> window_;
  vtkNew<vtkRenderer> renderer_;
  Side side_ = Side::Front;
  bool moved_ = false, outdated_ = true;
};

}  // namespace mien
