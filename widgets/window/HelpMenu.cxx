#include "HelpMenu.h"

#include <QApplication>
#include <QMainWindow>

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
}

/// The focus is looked at before the manual has it.
void HelpMenu::showManual() {
  const QWidget* focus = QApplication::focusWidget();
  if (!manual_) manual_ = new ManualWindow(window_);
  manual_->showSection(manual_->sectionOf(focus));
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
