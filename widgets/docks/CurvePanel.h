#pragma once

#include <QWidget>
#include <utility>
#include <vector>

#include "CurveEdit.h"
#include "CurveHandle.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QListWidget;
class QSpinBox;
class QTabWidget;
class QToolButton;

namespace mien {

class CurveView;
class FaceModel;
class FaceView;
class ScanPanel;

/// Where should the boundary curves of the neutral face lie? Points of curves are moved by numbers or dragged in the
/// view of the curves, with a smooth fall-off and mirrored or not; the moves stand in a list, from which they can be
/// taken, and the curves are saved.
class CurvePanel : public QWidget {
  Q_OBJECT
 public:
  CurvePanel(FaceModel* model, FaceView* face, CurveView* view, QWidget* parent = nullptr);

  bool save(const QString& fileName);  ///< the edited neutral curves as .vtp; the message bar says what is wrong

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* placeRow();
  QWidget* moveRow();
  QWidget* listColumn();
  QWidget* rowOf(const std::vector<std::pair<QString, QWidget*>>& controls);
  void describeTabs();
  void giveRoom();
  void describePlace();
  void describeMove();
  void describeButtons();
  void connectControls();
  void connectHandle();
  CurveEdit editOfControls() const;
  bool show(const std::vector<CurveEdit>& edits);
  void grab(int curve, int point);
  void drag(const CurveHandle::Vector& move);
  void apply();
  void remove(int index);
  void chooseSaved();
  void showEdits();

  FaceModel* model_;
  CurveHandle* handle_;
  QTabWidget* tabs_;
  ScanPanel* scan_;
  std::vector<CurveEdit> beforeDrag_;
  QComboBox* curve_;
  QSpinBox *point_, *spread_;
  QDoubleSpinBox *dx_, *dy_, *dz_, *width_;
  QCheckBox* mirror_;
  QListWidget* edits_;
  QLabel* hint_;
  QToolButton *apply_, *drag_, *undo_, *remove_, *clear_, *save_;
};

}  // namespace mien
