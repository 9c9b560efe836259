#pragma once

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <QObject>
#include <array>
#include <vector>

class vtkActor;
class vtkActor2D;
class vtkPoints;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkRenderer;
class vtkTextActor;

namespace mien {

class FaceModel;
class RenderView;

/// The 29 boundary curves as lines on the face, and their names beside it: C1, C3 .. left, C2, C4 .. right, each
/// joined to the outermost point of its curve as it is seen.
class CurveOverlay : public QObject {
  Q_OBJECT
 public:
  CurveOverlay(FaceModel* model, RenderView* view, QObject* parent);
  ~CurveOverlay() override;

  void setCurvesVisible(bool visible);
  void setNamesVisible(bool visible);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  static constexpr int count = 29;
  using Places = std::array<std::array<double, 2>, count>;  ///< pixels

  void addCurves();
  void addNames();
  void useTheme();
  void prepare();
  void placeNames();
  Places outermost(vtkPolyData* curves) const;
  std::vector<double> heights(const std::vector<int>& curves, const Places& places) const;
  void placeSide(bool right, const Places& places);

  FaceModel* model_;
  RenderView* view_;
  vtkNew<vtkPolyDataMapper> curveMapper_;
  vtkNew<vtkActor> curves_;
  vtkNew<vtkPoints> leaderPoints_;
  vtkNew<vtkPolyData> leaderLines_;
  vtkNew<vtkActor2D> leaders_;
  std::array<vtkNew<vtkTextActor>, count> names_;
  bool named_ = false;
  vtkSmartPointer<vtkRenderer> renderer_;  ///< may outlive the view
  unsigned long started_ = 0;
};

}  // namespace mien
