#pragma once

#include <vtkPolyData.h>

#include "RenderView.h"

class vtkActor;
class vtkLookupTable;
class vtkPolyDataMapper;

namespace mien {

/// Which boundary curves move, and how far? The 29 curves as lines and points, coloured by how far they have
/// moved (mm), over the neutral ones; the turns of the head are left out unless they are asked for.
///
/// The range of the colours is fixed, or it is automatic: a round number that grows with the movement, and begins anew
/// with another animation, without an animation with a face at rest, and with a change of what counts.
class CurveView : public RenderView {
  Q_OBJECT
 public:
  CurveView(FaceModel* model, QWidget* parent = nullptr);
  ~CurveView() override;

  void setPointsVisible(bool visible);
  void setNeutralVisible(bool visible);
  void setBackHidden(bool hidden);  ///< whether the face hides the curves behind it
  void setWithHead(bool on);        ///< whether the turns of the head (FAP 48 .. 50) count as movement; off
  void setFixedRange(double end);   ///< mm, of the last colour; 0 (the default): automatic
  bool isWithHead() const { return withHead_; }
  double rangeEnd() const;  ///< mm, in effect
  double automaticEnd() const { return automatic_; }
  double most() const { return most_; }  ///< mm that a point of a curve has moved
  void useTheme() override;

 signals:
  void movementChanged();  ///< or the range of its colours

 private:
  void follow();
  void growRange();
  void addCurves();
  void addNeutral();
  void addSkin();
  void dress();
  void sizePoints();

  vtkNew<vtkLookupTable> colors_;
  vtkNew<vtkPolyData> curves_;  ///< those shown, with the point array `Movement` (mm)
  bool withHead_ = false, pointsOn_ = true;
  double spacing_ = 0.0;  ///< mm between points of a curve
  double fixed_ = 0.0, automatic_ = 0.0, most_ = 0.0;
  vtkNew<vtkActor> lines_, points_, neutral_, skin_;
};

}  // namespace mien
