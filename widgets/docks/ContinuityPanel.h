#pragma once

#include <vtkNew.h>

#include <QWidget>

#include "CameraFlight.h"
#include "FaceOverlay.h"
#include "Figure.h"
#include "PipelineErrors.h"
#include "SchemeContinuity.h"

class QComboBox;
class vtkPDEFaceFilter;

namespace mien {

class ContinuityTable;
class FaceModel;
class FigureView;

/// How smoothly do the patches meet? A table of the eight seams, or of all schemes; the profile of a measure along the
/// chosen seam; angle, curvature or zebra stripes on the face. Choosing a seam flies the camera there.
class ContinuityPanel : public QWidget {
  Q_OBJECT
 public:
  ContinuityPanel(FaceModel* model, FaceView* view, QWidget* parent = nullptr);
  ~ContinuityPanel() override;

 private:
  enum Table { Seams, Schemes };
  enum OnFace { Skin, Seamlines, MeanCurvature, GaussianCurvature, Zebra };

  QWidget* controls();
  void describeControls();
  void connectControls();
  bool comparesSchemes() const;
  void refresh();
  void measure();
  void fillTable();
  void markSeam();
  bool isSeam(int row) const;
  void flyToRow();
  void showProfile();
  void chooseRow();
  void useScheme(int row);
  void flyToSeam();
  void flyTo(double v);
  void paintFace();
  void paintSeams();
  void paintSurface(OnFace what);
  Figure profileFigure() const;
  std::string numbers() const;
  const SchemeContinuity& shown() const { return schemes_[shown_]; }

  FaceModel* model_;
  FaceView* view_;
  ContinuityTable* table_;
  FigureView* figure_;
  FaceOverlay* overlay_;
  CameraFlight* flight_;
  QComboBox *rows_, *part_, *measure_, *onFace_;
  std::vector<SchemeContinuity> schemes_;  ///< in the order of faceSchemes()
  std::vector<QString> faults_;            ///< of each scheme
  vtkNew<vtkPDEFaceFilter> fine_;
  PipelineErrors errors_;
  size_t shown_ = 0;  ///< the scheme of the face
  int seam_ = 0;
  double range_ = 0.0;     ///< of the colours of seams
  int rangeMeasure_ = -1;  ///< that the range was chosen for
};

}  // namespace mien
