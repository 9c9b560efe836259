#pragma once

#include <QMenu>

namespace mien {

class FaceModel;
class History;
class ViewArea;

/// Undo and redo, by the name of what they take back, and what can be copied.
class EditMenu : public QMenu {
  Q_OBJECT
 public:
  EditMenu(History* history, FaceModel* model, const ViewArea* views, QWidget* window);

 protected:
  /// Numbers have no history of their own: what was typed is undone as what it has changed.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void follow();

  History* history_;
  QAction *undo_, *redo_;
};

}  // namespace mien
