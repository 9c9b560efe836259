#pragma once

#include <vtkNew.h>

#include <QColor>

class vtkActor;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkRenderer;

namespace mien {

/// The inside of an open mouth in a view of the face, dark unless it is told otherwise: it hides what is behind it.
class MouthActor {
 public:
  explicit MouthActor(vtkRenderer* renderer);

  void follow(vtkPolyData* mouth);  ///< as the face is now (FaceModel::mouth)
  void setVisible(bool visible);
  void setColor(const QColor& color);
  void setBehind(double units);  ///< of depth, so that curves on its rim are seen

  /// Between lips that just part it has the colour of what is around it, and its own by degrees.
  /// @param lips  invalid: it is seen through instead
  void fadeFrom(const QColor& lips);

  static double shareOf(double gap);  ///< of its own colour, 0 .. 1, between lips that many mm apart

 private:
  void dress();

  QColor inside_, lips_;
  bool fades_ = false;
  vtkNew<vtkPolyDataMapper> mapper_;
  vtkNew<vtkActor> actor_;
};

}  // namespace mien
