#include "ViewMenu.h"

#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>

#include "ExportDialog.h"
#include "MessageBar.h"
#include "Theme.h"
#include "ViewArea.h"
#include "Workspaces.h"

namespace mien {

ViewMenu::ViewMenu(QMainWindow* window, ViewArea* views, Workspaces* workspaces, MessageBar* messages)
    : QMenu(tr("&View"), window), views_(views) {
  setObjectName("viewMenu");
  addSides();
  addSeparator();
  addExports(window);
  addSeparator();
  QMenu* arrangements = addMenu(tr("&Workspace"));
  arrangements->setObjectName("workspaceMenu");
  workspaces->addTo(arrangements);
  addSeparator();
  for (QDockWidget* dock : window->findChildren<QDockWidget*>()) addAction(dock->toggleViewAction());
  addSeparator();
  addAction(tr("&Messages..."), messages, &MessageBar::showLog)->setObjectName("actionMessages");
  addColours();
}

void ViewMenu::addSides() {
  const auto add = [&](const QString& text, int key, RenderView::Side side) {
    addAction(text, this, [this, side] { views_->look(side); })->setShortcut(Qt::CTRL | Qt::Key(key));
  };
  add(tr("&Front"), Qt::Key_1, RenderView::Side::Front);
  add(tr("&45 degrees"), Qt::Key_2, RenderView::Side::FortyFive);
  add(tr("&Side"), Qt::Key_3, RenderView::Side::Profile);
}

void ViewMenu::addExports(QWidget* window) {
  const auto add = [&](const QString& text, const char* name, Exporter* exporter) {
    addAction(text, this, [exporter, window] { ExportDialog::ask(exporter, window); })->setObjectName(name);
  };
  add(tr("&Export the face..."), "actionExportFace", views_->faceExporter());
  add(tr("Export the &curve view..."), "actionExportCurves", views_->curveExporter());
}

void ViewMenu::addColours() {
  QAction* dark = addAction(tr("&Dark colours"));
  dark->setObjectName("actionDark");
  dark->setCheckable(true);
  dark->setChecked(Theme::current().kind == Theme::Kind::Dark);
  connect(dark, &QAction::toggled, this, [this](bool on) {
    Theme::choose(on ? Theme::Kind::Dark : Theme::Kind::Light, *qApp);
    views_->useTheme();
  });
}

}  // namespace mien
