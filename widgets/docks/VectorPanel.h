#pragma once

#include <vtkNew.h>

#include <QWidget>
#include <vector>

#include "ExportDrawing.h"

class ElidedLabel;
class vtkEventQtSlotConnect;

namespace mien {

class FaceModel;
class LiveMotion;
class LiveUpdate;
class OriginChooser;
class RenderView;
class VectorControls;
class VectorView;
struct MotionRequest;
struct MotionWords;

/// How does the face move? Its motion vectors against the neutral face, the frame before or a pinned state, live.
class VectorPanel : public QWidget {
  Q_OBJECT
 public:
  /// @param view  whose direction can be taken over
  VectorPanel(FaceModel* model, RenderView* view, QWidget* parent = nullptr);
  ~VectorPanel() override;

  const LiveMotion& motion() const { return *motion_; }

 public slots:
  void fit();  ///< chooses automatic scale and range anew

 protected:
  void changeEvent(QEvent* event) override;

 private slots:
  void cameraMoved();

 private:
  QWidget* header();
  QWidget* side();
  void connectAll();
  void followCamera(RenderView* view);
  void followAnimation();
  void refresh();
  void show();
  void fitToScreen(MotionRequest& request) const;
  MotionWords words() const;
  ExportDrawing drawing(const ExportOptions& asked) const;
  std::string numbers() const;
  QString summary() const;

  FaceModel* model_;
  OriginChooser* origin_;
  VectorControls* controls_;
  VectorView* figure_;
  ElidedLabel* numbers_;
  LiveMotion* motion_;
  LiveUpdate* live_;
  std::vector<int> samples_;  ///< of the animation's frames
  vtkNew<vtkEventQtSlotConnect> cameraEvents_;
};

}  // namespace mien
