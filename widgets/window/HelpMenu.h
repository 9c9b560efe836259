#pragma once

#include <QMenu>
#include <QPointer>

class QMainWindow;

namespace mien {

class ManualWindow;

/// The manual at the section of what was clicked in, or got the focus, last, the keys, the tour, and what this program
/// is made of.
class HelpMenu : public QMenu {
  Q_OBJECT
 public:
  explicit HelpMenu(QMainWindow* window);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void showManual();
  void showShortcuts();
  void showTour();
  void showAbout();

  QMainWindow* window_;
  QPointer<QWidget> visited_;
  ManualWindow* manual_ = nullptr;
};

}  // namespace mien
