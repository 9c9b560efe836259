#pragma once

#include <QMenu>

class QMainWindow;

namespace mien {

class MessageBar;
class ViewArea;
class Workspaces;

/// From where the face is seen, which docks are open, workspaces, messages and colours.
class ViewMenu : public QMenu {
  Q_OBJECT
 public:
  ViewMenu(QMainWindow* window, ViewArea* views, Workspaces* workspaces, MessageBar* messages);

 private:
  void addSides();
  void addExports(QWidget* window);
  void addColours();

  ViewArea* views_;
};

}  // namespace mien
