#pragma once

#include <vtkPolyData.h>

#include "FaceState.h"
#include "MouthActor.h"
#include "RenderView.h"

class vtkActor;
class vtkLookupTable;
class vtkPolyDataMapper;

namespace mien {

/// Which boundary curves move, and how far? The 29 curves as lines and points, coloured by how far they have
/// moved (mm), over the neutral ones; the turns of the head are left out unless they are asked for.
///
/// The range of the colours is fixed, or it is automatic: a round number that holds the movement of the face shown, of
/// the ends of its animation, and of the frames of it seen while nothing else of the state changed.
class CurveView : public RenderView {
  Q_OBJECT
 public:
  CurveView(FaceModel* model, QWidget* parent = nullptr);
  ~CurveView() override;

  void setPointsVisible(bool visible);
  void setNeutralVisible(bool visible);
  void setBackHidden(bool hidden);  ///< whether the face and its mouth hide the curves behind them
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
  void followRange();
  void showRange();
  void addCurves();
  void addNeutral();
  void addSkin();
  void dress();
  void sizeDrawing();
  double pixelsBetween() const;  ///< points of curves, or curves

  vtkNew<vtkLookupTable> colors_;
  vtkNew<vtkPolyData> curves_;  ///< those shown, with the point array `Movement` (mm)
  bool withHead_ = false;
  double spacing_ = 0.0;  ///< mm between points of curves, or between curves
  double fixed_ = 0.0, automatic_ = 0.0, most_ = 0.0;
  double played_ = 0.0;  ///< mm, the most in any frame seen of motion_
  FaceState motion_;     ///< without its frame
  vtkNew<vtkActor> lines_, points_, neutral_, skin_;
  MouthActor mouth_{renderer()};
};

}  // namespace mien
