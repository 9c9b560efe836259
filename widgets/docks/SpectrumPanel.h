#pragma once

#include <vtkNew.h>

#include <QWidget>

#include "FaceOverlay.h"
#include "Figure.h"
#include "PipelineErrors.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QToolButton;
class vtkPDEModeFilter;

namespace mien {

class FaceModel;
class FigureView;

/// What does each Fourier mode add to the face? A bar per mode and for the remainder, the error of partial sums, and
/// the contribution of a chosen mode on the face, in mm.
class SpectrumPanel : public QWidget {
  Q_OBJECT
 public:
  SpectrumPanel(FaceModel* model, FaceView* view, QWidget* parent = nullptr);
  ~SpectrumPanel() override;

 private:
  QWidget* controls();
  void connectControls();
  void refresh();
  bool measure();
  void choose(int row);
  void listModes();
  void showFigure();
  void showNumbers();
  void paintFace();
  double colorRange(double largest);
  Figure shownFigure() const;
  int rowCount() const;

  FaceModel* model_;
  FigureView* figure_;
  FaceOverlay* overlay_;
  QComboBox *measure_, *mode_;
  QCheckBox* partial_;
  QToolButton* onFace_;
  QLabel* numbers_;
  vtkNew<vtkPDEModeFilter> modes_;
  PipelineErrors errors_;
  int row_ = 1, rangeRow_ = -1;  ///< of the table; the row that the colours were chosen for
  double range_ = 0.0;           ///< mm
};

}  // namespace mien
