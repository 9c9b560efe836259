#pragma once

#include <QMenu>

class QMainWindow;

namespace mien {

class MessageBar;
class ViewArea;
class Workspaces;

/// What is seen and how, in sections: camera, drawing, curves, workspaces and docks, pictures, and the window itself.
class ViewMenu : public QMenu {
  Q_OBJECT
 public:
  ViewMenu(QMainWindow* window, ViewArea* views, Workspaces* workspaces, MessageBar* messages);

 private:
  void addSides();
  void addDrawing();
  void addCurves();
  void addDocks(Workspaces* workspaces);
  void addExports();
  void addAppearance(MessageBar* messages);
  void addButton(QMenu* menu, const QString& text, const char* name);
  void addChoices(const QString& title, const char* menuName, const char* name);

  QMainWindow* window_;
  ViewArea* views_;
};

}  // namespace mien
