#pragma once

#include <QWidget>

#include "FaceCurves.h"
#include "Figure.h"
#include "SmoothingSweep.h"
#include "ThumbnailStrip.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QStackedWidget;
class QToolButton;

namespace mien {

class BackgroundTask;
class FaceModel;
class FigureView;

/// How does the smoothing parameter a change the face? A measure over a, with a cursor that sets a; all schemes if
/// wanted; small pictures of the face at a few a. Computed off the GUI thread, and anew only when something other than
/// a changes.
class SmoothingPanel : public QWidget {
  Q_OBJECT
 public:
  SmoothingPanel(FaceModel* model, QWidget* parent = nullptr);
  ~SmoothingPanel() override;

 private:
  /// All that a sweep depends on.
  struct Subject {
    FaceCurves face;
    SmoothingSweepOptions sweep;
    bool asksTheSameAs(const Subject& other) const;  ///< whatever the face
    bool sameAs(const Subject& other) const;
  };

  QWidget* controls();
  QWidget* said();
  void describeControls();
  void connectControls();
  void refresh();
  void tellSpacing();
  void markPresent();
  bool readRange();
  bool takeSubject(Subject& subject);
  void startSweep(bool afterTheLast);
  void startThumbnails();
  void showFigure();
  void reachPresent(Chart& panel) const;
  void setSmoothing(double a);
  void step(int steps);
  Figure sweepFigureOfAll() const;
  std::string numbers() const;

  FaceModel* model_;
  FigureView* figure_;
  ThumbnailStrip* thumbnails_;
  BackgroundTask *sweep_, *pictures_;
  QComboBox* measure_;
  QCheckBox* allSchemes_;
  QLineEdit* range_;
  QStackedWidget* said_;
  QLabel* spacing_;
  QProgressBar* progress_;
  QToolButton* cancel_;
  Subject subject_;
  std::vector<double> values_;  ///< of a
  std::vector<SweepRecord> records_;
  SmoothingSweepOptions swept_;  ///< that the records come from
  bool cancelled_ = false;
};

}  // namespace mien
