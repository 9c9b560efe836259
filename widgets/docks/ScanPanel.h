#pragma once

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <QWidget>
#include <vector>

#include "DistanceMap.h"
#include "ScanReportText.h"
#include "SessionPart.h"

class QCheckBox;
class QComboBox;
class QMimeData;
class QProgressBar;
class QToolButton;
class vtkActor;

namespace mien {

class BackgroundTask;
class FaceModel;
class FaceView;
class RangeBox;
class ScanReportView;

/// What face does a scan have, and how far is the present one from it? A scan is measured off the GUI thread and shown
/// beside the face; its curves can become the face, and distances are shown as colours.
class ScanPanel : public QWidget, public SessionPart {
  Q_OBJECT
 public:
  ScanPanel(FaceModel* model, FaceView* view, QWidget* parent = nullptr);
  ~ScanPanel() override;

  void open(const QString& fileName);                 ///< a scan: .ply .obj .stl .off
  void openLandmarks(const QString& fileName);        ///< of the scan, .csv; empty: they are found by fitting
  bool adopt(const QString& fileName);                ///< writes the measured curves as .vtp and makes them the face
  static QString droppedFile(const QMimeData* data);  ///< one that openDropped() takes, or nothing
  void openDropped(const QString& fileName);
  bool isMeasuring() const;
  bool hasScan() const { return scan_; }
  bool isOpen() const { return !file_.isEmpty(); }  ///< be it measured or not
  void close();                                     ///< forgets the scan and its landmarks, and stops measuring

  nlohmann::json sessionState() const override;  ///< file names `scan` and `landmarks`; empty without
  QString changeName() const override { return tr("scan"); }
  void restoreSession(const nlohmann::json& state) override;

 signals:
  void opened();       ///< whatever came of it
  void scanChanged();  ///< there is another one, or none, or one that is being measured

 private:
  struct Found;
  void describeButtons();
  void describeMap();
  QWidget* row(const QString& name, const std::vector<QWidget*>& controls);
  void connectButtons();
  void connectMap();
  void measure();
  void forget();
  void take(const Found& found);
  void choose();
  void chooseLandmarks(bool on);
  void chooseAdopted();
  void showLandmarkFile();
  void addReport();
  void showReport();
  void followCurves();
  void showScan();
  bool isAdopted() const;  ///< whether the shown face is the measured curves
  bool isHiddenByColors() const;
  void tellVisible();
  void followOverlay(const QObject* overlay);

  FaceModel* model_;
  FaceView* view_;
  BackgroundTask* task_;
  DistanceMap* map_;
  QToolButton *open_, *landmarks_, *adopt_, *cancel_;
  QComboBox *unit_, *subject_;
  QCheckBox *visible_, *frontal_;
  RangeBox* largest_;
  QProgressBar* progress_;
  ScanReportView* report_;
  vtkNew<vtkActor> actor_;
  vtkSmartPointer<vtkPolyData> curves_, scan_;
  std::vector<ScanReportLine> found_;
  vtkMTimeType curvesTime_ = 0;  ///< of the face's own, when the report was told
  QString file_, landmarkFile_;
  bool colored_ = false;  ///< whether colours on the face mean something
  QString framed_;        ///< the scan that the camera has been moved back for
};

}  // namespace mien
