#pragma once

#include <QHash>
#include <QWidget>

class QCheckBox;
class QLineEdit;
class QStackedWidget;
class QTabBar;
class QToolButton;
class QVBoxLayout;

namespace mien {

class FAPList;
class FAPRow;
class FaceModel;

/// How does each facial animation parameter move the face? The 22 FAPs of Sheng et al. 2011, a tab for each feature, or
/// all that have surface in one list. While sides are locked, a FAP takes its mirror partner along.
class FAPPanel : public QWidget {
  Q_OBJECT
 public:
  FAPPanel(FaceModel* model, QWidget* parent = nullptr);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* header();
  QWidget* footer();
  QWidget* searchField();
  void addTab(int group, const QString& title);
  void addRow(int fap);
  void arrange();
  void showPartners();
  void edit(int fap, double value);
  void resetAll();
  void follow();
  void followTable();

  FaceModel* model_;
  QToolButton* all_;
  QLineEdit* search_;
  QTabBar* tabs_;
  QStackedWidget *head_, *pages_;
  FAPList* list_;
  QCheckBox* mirror_;
  QHash<int, FAPRow*> rows_;
  QHash<int, QVBoxLayout*> tabColumns_;  ///< by group
  bool isChosen_ = false;                ///< by the user: whether all or those of a tab
  bool isFitting_ = false;
};

}  // namespace mien
