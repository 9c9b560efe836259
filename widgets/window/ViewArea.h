#pragma once

#include <QWidget>
#include <array>
#include <vector>

#include "Comparison.h"
#include "ExportDrawing.h"
#include "FaceView.h"

class QComboBox;
class QSplitter;
class QToolButton;

namespace mien {

class ComparisonSummary;
class CurveOverlay;
class CurveView;
class DifferenceArrows;
class FaceColoring;
class FaceModel;
class Exporter;
class ViewFrame;

/// The views in the middle of the window, side by side: the face, the one that it is compared with, and the curves;
/// above them what the faces show. Where there is no room for three, a comparison takes the place of the curves.
class ViewArea : public QWidget {
  Q_OBJECT
 public:
  ViewArea(FaceModel* model, FaceView* face, CurveView* curves, QWidget* parent = nullptr);

  ViewFrame* faceFrame() const { return faceFrame_; }
  Comparison* comparison() const { return comparison_; }
  FaceColoring* coloring() const { return coloring_; }
  FaceView* face() const { return face_; }
  bool showsCurves() const { return curvesOn_; }  ///< on the face
  bool showsNames() const { return namesOn_; }    ///< of the curves

  Exporter* faceExporter() const { return faceExporter_; }
  Exporter* curveExporter() const { return curveExporter_; }

  void look(RenderView::Side side);
  void useTheme();

 signals:
  void cameraMoved();  ///< of any of the views
  void colorChosen();  ///< by the user

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* displayRow();
  QWidget* splitter();
  void shareOut();
  void addMeshChoice();
  void addSideButtons();
  void addCurveFrame();
  void addOther();
  void addOtherButtons();
  void addSummary(ViewFrame* frame);
  void followComparison();
  void holdMesh();
  void showCurves();
  QString summaryOf(Comparison::Side side) const;
  void showDifference();
  void arrange();
  void keepFeet();
  void linkCameras(bool linked);
  void showWhole();
  void addExporters();
  ExportDrawing faceDrawing(const ExportOptions& options) const;
  std::string faceNumbers() const;

  FaceModel* model_;
  FaceView* face_;
  CurveView* curves_;
  Comparison* comparison_;
  FaceColoring* coloring_;
  ViewFrame *faceFrame_, *curveFrame_, *otherFrame_ = nullptr;
  FaceView* other_ = nullptr;
  std::vector<CurveOverlay*> overlays_;
  std::vector<DifferenceArrows*> arrows_;
  std::vector<ComparisonSummary*> summaries_;
  std::vector<std::array<double, 3>> held_;  ///< of the mesh that is compared, by the camera
  Exporter *faceExporter_ = nullptr, *curveExporter_ = nullptr;
  QWidget *faceKey_ = nullptr, *curveKey_ = nullptr, *curveFoot_ = nullptr;
  QComboBox* mesh_;
  QSplitter* splitter_;
  QToolButton* swap_ = nullptr;
  bool curvesOn_ = false, namesOn_ = false;
};

}  // namespace mien
