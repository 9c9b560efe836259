#pragma once

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <Eigen/Core>
#include <QObject>
#include <array>
#include <optional>

#include "PipelineErrors.h"

class vtkBillboardTextActor3D;
class vtkFDTDeformationFilter;
class vtkFDTReader;
class vtkFacialRegionFilter;
class vtkPDEFaceFilter;
class vtkPolyData;
class vtkRenderer;
class vtkReverseSense;
class vtkGeometryFilter;

namespace mien {

class FaceModel;
class FaceOverlay;
class FaceView;

/// The 16 regions of a facial deformation table on the face, coloured and numbered; one can stand out.
class RegionOverlay : public QObject {
  Q_OBJECT
 public:
  RegionOverlay(FaceModel* model, FaceView* view, QObject* parent);
  ~RegionOverlay() override;

  void show();  ///< the face as it is now
  void hide();
  void emphasise(int region);  ///< 1 .. 16; 0: all alike
  bool isShown() const;

 signals:
  void shownChanged(bool shown);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  std::string build();
  void paint();
  void color(vtkPolyData* skin) const;
  void placeNumbers(const Eigen::Vector3d& eye);
  void turnNumbers();
  void removeNumbers();

  FaceModel* model_;
  FaceView* view_;
  vtkSmartPointer<vtkRenderer> renderer_;
  FaceOverlay* overlay_;
  vtkNew<vtkPDEFaceFilter> fine_;
  vtkNew<vtkFacialRegionFilter> regions_;
  vtkNew<vtkFDTReader> table_;
  vtkNew<vtkFDTDeformationFilter> deformation_;
  vtkNew<vtkGeometryFilter> geometry_;
  vtkNew<vtkReverseSense> outwards_;
  PipelineErrors errors_;
  std::array<vtkNew<vtkBillboardTextActor3D>, 16> numbers_;
  vtkSmartPointer<vtkPolyData> skin_;   ///< that the numbers stand on
  std::optional<Eigen::Vector3d> eye_;  ///< where the numbers were placed for
  unsigned long started_ = 0;
  int region_ = 0;
};

}  // namespace mien
