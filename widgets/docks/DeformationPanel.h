#pragma once

#include <QWidget>

#include "Figure.h"

class QComboBox;
class QLabel;
class QStackedWidget;
class QToolButton;

namespace mien {

class CoefficientTable;
class DeformationChoice;
class ElidedLabel;
class EmptyState;
class FaceModel;
class FaceView;
class FigureView;
class PresentTable;
class RegionOverlay;

/// What does a facial deformation table do to the face, and which table is the face as it stands? Applies a table; fits
/// one from two states, names the expression, and shows its coefficients beside the range of that expression. While
/// nothing moves it offers examples instead.
class DeformationPanel : public QWidget {
  Q_OBJECT
 public:
  DeformationPanel(FaceModel* model, FaceView* view, QWidget* parent = nullptr);
  ~DeformationPanel() override;

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  QWidget* controls();
  QWidget* fitRow();
  QWidget* detailRow();
  QWidget* expressionColumn();
  EmptyState* emptyState();
  void describeControls();
  void connectControls();
  void refresh();
  void showExpression();
  void showCoefficients();
  void showPage();
  void showRegion(bool asked);
  int nearest() const;
  Figure figure() const;

  FaceModel* model_;
  PresentTable* present_;
  DeformationChoice* choice_;
  RegionOverlay* overlay_;
  CoefficientTable* coefficients_;
  FigureView* figure_;
  QStackedWidget* pages_;
  QWidget* range_;
  QComboBox *shown_, *mean_;
  ElidedLabel *detail_, *origin_, *expression_;
  QLabel* unit_;
  QToolButton* onFace_;
};

}  // namespace mien
