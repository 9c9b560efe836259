#pragma once

#include <QMenu>

class QMainWindow;

namespace mien {

class ManualWindow;

/// The manual at the section of what has the focus, the keys, the tour, and what this program is made of.
class HelpMenu : public QMenu {
  Q_OBJECT
 public:
  explicit HelpMenu(QMainWindow* window);

 private:
  void showManual();
  void showShortcuts();
  void showTour();
  void showAbout();

  QMainWindow* window_;
  ManualWindow* manual_ = nullptr;
};

}  // namespace mien
