#pragma once

#include "RenderView.h"

class vtkActor;
class vtkLookupTable;

namespace mien {

/// Which boundary curves move, and how far? The 29 curves as lines and points, coloured by how far they have
/// moved (mm), over the neutral ones; the colours mean the same lengths at all times.
class CurveView : public RenderView {
  Q_OBJECT
 public:
  static constexpr double fullColorLength = 10.0;  ///< mm

  CurveView(FaceModel* model, QWidget* parent = nullptr);
  ~CurveView() override;

  void setPointsVisible(bool visible);
  void setNeutralVisible(bool visible);
  void setBackHidden(bool hidden);  ///< whether the face hides the curves behind it
  void useTheme() override;

 private:
  void addCurves();
  void addNeutral();
  void addSkin();
  void dress();

  vtkNew<vtkLookupTable> colors_;
  vtkNew<vtkActor> lines_, points_, neutral_, skin_;
};

}  // namespace mien
