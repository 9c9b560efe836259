#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <QObject>
#include <QString>

#include "FaceOverlay.h"

namespace mien {

class BackgroundTask;
class FaceModel;
class FaceView;

/// How far the face lies from a scan, as colours on one of them in the face view. Measured off the GUI thread, and
/// again whenever the face has changed.
class DistanceMap : public QObject {
  Q_OBJECT
 public:
  enum class Subject { None, Face, Scan };

  DistanceMap(FaceModel* model, FaceView* view, QObject* parent);
  ~DistanceMap() override;

  void setScan(vtkPolyData* scan);  ///< mm, in the frame of the face; nullptr: none
  void setSubject(Subject subject);
  void setFrontalOnly(bool on);         ///< whether the numbers take z > 50 mm only
  void setLargest(double millimetres);  ///< of the colours; 0 (the default): automatic
  double automaticLargest() const {
    return automatic_;
  }  ///< round, 95 % lie below; grows, and begins anew with setSubject()
  Subject subject() const { return subject_; }
  QString summary() const {
    return summary_;
  }  ///< RMS, median, 95th percentile and largest, in words; empty without a map

 signals:
  void changed();

 private:
  struct Measured;
  static Measured measure(vtkPolyData* face, vtkPolyData* scan, bool frontal, int direction,
                          const std::function<bool(double)>& goOn);
  void follow();
  void take(const Measured& measured);
  void draw();

  FaceModel* model_;
  BackgroundTask* task_;
  FaceOverlay overlay_;
  vtkSmartPointer<vtkPolyData> scan_, map_;
  Subject subject_ = Subject::None;
  bool frontal_ = true;
  double largest_ = 0.0, automatic_ = 0.0;  ///< mm
  QString summary_;
};

}  // namespace mien
