#pragma once

#include <QVTKOpenGLNativeWidget.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <QPointer>
#include <array>
#include <vector>

#include "SessionPart.h"

class vtkCamera;
class vtkGenericOpenGLRenderWindow;
class vtkRenderer;

namespace mien {

class FaceModel;
struct FaceOutline;
struct ViewAxes;

/// A three-dimensional view of the face: light, background, camera and mouse. What is in it, its subclasses say.
///
/// The face, and all that it reaches while it moves, fills the view until the user moves the camera; fit() goes back to
/// that.
class RenderView : public QVTKOpenGLNativeWidget, public SessionPart {
  Q_OBJECT
 public:
  enum class Side { Front, FortyFive, Profile };

  RenderView(FaceModel* model, QWidget* parent);
  ~RenderView() override;

  void look(Side side);
  /// Looks at `focus` (mm) from the end of `direction`, a unit vector, at a distance in mm; the user's own camera from
  /// then on.
  void placeCamera(const std::array<double, 3>& focus, const std::array<double, 3>& direction, double distance);
  void fit();  ///< the side looked from last, the whole face in the view, and what is shown with it

  /// What else the camera takes in the next time it is placed, and that of its twin; nullptr: the face alone.
  /// @param bounds  x, y, z from and to, in mm
  void setCompany(const double* bounds);

  /// The same for some points (mm), of which each stays that many pixels within the view; none: the face alone.
  void setCompany(const std::vector<std::array<double, 3>>& points, int margin);

  /// Pixels at the lower edge that a key may cover: what fills the view ends above them, its background goes on.
  void setFoot(int pixels);
  int foot() const { return foot_; }
  int freeHeight() const;  ///< pixels above the foot

  /// What linked views of different sizes have in common.
  enum class Zoom {
    Filling,  ///< what fills one fills the other
    ToScale   ///< a millimetre is as many pixels, so that both can be compared
  };

  /// Turns and zooms together with the other view, and with all that it is linked with.
  void link(RenderView* other, Zoom zoom = Zoom::Filling);  ///< which leads: linked views take in what it does
  void unlink();                                            ///< from all
  bool isLinked() const { return !partners_.empty(); }
  bool isMoved() const { return moved_; }  ///< whether the user has placed the camera
  vtkCamera* camera() const;

  /// `side`, and where the user has placed the camera `position`, `focus` and `up` (mm).
  nlohmann::json sessionState() const override;
  void restoreSession(const nlohmann::json& state) override;
  bool isUndoable() const override { return false; }

  vtkRenderer* renderer() const { return renderer_; }
  void redraw();                                      ///< with the next paint event
  virtual void useTheme();                            ///< takes the colours of the current theme
  virtual bool showsSurface() const { return true; }  ///< behind lines that are drawn on it; else the background

 signals:
  void cameraMoved();  ///< by the user, back to the whole face, or with another view

 protected:
  void paintGL() override;
  void resizeEvent(QResizeEvent* event) override;
  bool event(QEvent* event) override;
  FaceModel& model() { return *model_; }

 private:
  void addLights();
  void observeMouse();
  void userMoved();
  bool pressKey(int key);
  void placeCamera();
  void raiseCentre();
  void followReach();
  const RenderView& leader() const;          ///< of those that are linked; itself where none is
  std::array<double, 4> fittingBox() const;  ///< left, right, low, high of the whole face, mm
  double fittingDistance() const;            ///< from which the whole face fills this view
  double distanceTo(double width, double height) const;
  double millimetresPerPixel(double width, double height) const;
  void addCompany(const ViewAxes& axes, FaceOutline& outline) const;
  bool hasTwin() const;
  void takeCamera(const RenderView* other);
  void forget(const RenderView* other);
  void passCamera(const RenderView* except = nullptr);

  FaceModel* model_;
  vtkNew<vtkGenericOpenGLRenderWindow> window_;
  vtkNew<vtkRenderer> renderer_;
  std::vector<QPointer<RenderView>> partners_;  ///< a tree: no view is reached in two ways
  QPointer<RenderView> leader_;                 ///< that this was linked with
  QPointer<RenderView> twin_;                   ///< linked to scale
  std::vector<std::array<double, 3>> company_;
  int companyMargin_ = 0;  ///< pixels
  int foot_ = 0;
  Side side_ = Side::Front;
  bool moved_ = false, outdated_ = true;
};

}  // namespace mien
