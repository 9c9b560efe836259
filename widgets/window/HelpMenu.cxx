#include "HelpMenu.h"

#include <QApplication>
#include <QDockWidget>
#include <QFocusEvent>
#include <QMainWindow>
#include <QMenuBar>
#include <QMouseEvent>

#include "AboutDialog.h"
#include "ManualWindow.h"
#include "ShortcutDialog.h"
#include "Tour.h"

namespace mien {

HelpMenu::HelpMenu(QMainWindow* window) : QMenu(tr("&Help"), window), window_(window) {
  setObjectName("helpMenu");
  QAction* manual = addAction(tr("&Manual"), this, &HelpMenu::showManual);
  manual->setObjectName("actionManual");
  manual->setShortcut(QKeySequence(Qt::Key_F1));
  addAction(tr("&Keyboard shortcuts"), this, &HelpMenu::showShortcuts)->setObjectName("actionShortcuts");
  addAction(tr("&Tour"), this, &HelpMenu::showTour)->setObjectName("actionTour");
  addSeparator();
  addAction(tr("&About Mien Studio"), this, &HelpMenu::showAbout)->setObjectName("actionAbout");
  qApp->installEventFilter(this);
}

/// Much that can be clicked in takes no focus: what was pressed or has got the focus last is where the user is.
bool HelpMenu::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::MouseButtonPress && event->type() != QEvent::FocusIn) return false;
  auto* widget = qobject_cast<QWidget*>(watched);
  if (!widget || qobject_cast<QMenuBar*>(widget)) return false;
  if (widget->window() != window_ && !qobject_cast<QDockWidget*>(widget->window())) return false;
  if (event->type() == QEvent::MouseButtonPress && widget->childAt(static_cast<QMouseEvent*>(event)->pos()))
    return false;  // which its child did not want
  if (event->type() == QEvent::FocusIn) {
    const Qt::FocusReason reason = static_cast<QFocusEvent*>(event)->reason();
    if (reason == Qt::ActiveWindowFocusReason || reason == Qt::PopupFocusReason || reason == Qt::MenuBarFocusReason)
      return false;
  }
  visited_ = widget;
  return false;
}

/// Looked at before the manual has the focus.
void HelpMenu::showManual() {
  const QWidget* place = visited_ && visited_->isVisible() ? visited_.data() : QApplication::focusWidget();
  if (!manual_) manual_ = new ManualWindow(window_);
  manual_->showSection(manual_->sectionOf(place));
}

void HelpMenu::showShortcuts() {
  auto* dialog = new ShortcutDialog(*window_, window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->show();
}

void HelpMenu::showTour() {
  Tour::begin(*window_);
}

void HelpMenu::showAbout() {
  auto* dialog = new AboutDialog(window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->show();
}

}  // namespace mien
