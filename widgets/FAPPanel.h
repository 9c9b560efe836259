#pragma once

#include <QHash>
#include <QWidget>

class QCheckBox;
class QTabWidget;

namespace mien {

struct FAPDefinition;
class FaceModel;
class FAPRow;

/// How does each facial animation parameter move the face? The 22 FAPs of Sheng et al. 2011, a tab for each feature.
class FAPPanel : public QWidget {
  Q_OBJECT
 public:
  FAPPanel(FaceModel* model, QWidget* parent = nullptr);

 private:
  void addTab(int group, const QString& title);
  QWidget* footer();
  void edit(int fap, double value);
  void resetAll();
  void follow();

  FaceModel* model_;
  QTabWidget* tabs_;
  QCheckBox* mirror_;
  QHash<int, FAPRow*> rows_;
};

}  // namespace mien
