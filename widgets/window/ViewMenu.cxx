#include "ViewMenu.h"

#include <QAbstractButton>
#include <QActionGroup>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QMainWindow>

#include "ExportDialog.h"
#include "MessageBar.h"
#include "Theme.h"
#include "ViewArea.h"
#include "Workspaces.h"

namespace mien {

ViewMenu::ViewMenu(QMainWindow* window, ViewArea* views, Workspaces* workspaces, MessageBar* messages)
    : QMenu(tr("&View"), window), window_(window), views_(views) {
  setObjectName("viewMenu");
  addSection(tr("Camera"));
  addSides();
  addSection(tr("Face"));
  addDrawing();
  addSection(tr("Curves"));
  addCurves();
  addSection(tr("Workspace and docks"));
  addDocks(workspaces);
  addSection(tr("Pictures"));
  addExports();
  addSection(tr("Window"));
  addAppearance(messages);
}

void ViewMenu::addSides() {
  const auto add = [&](const QString& text, int key, RenderView::Side side) {
    addAction(text, this, [this, side] { views_->look(side); })->setShortcut(Qt::CTRL | Qt::Key(key));
  };
  add(tr("&Front"), Qt::Key_1, RenderView::Side::Front);
  add(tr("&45 degrees"), Qt::Key_2, RenderView::Side::FortyFive);
  add(tr("&Side"), Qt::Key_3, RenderView::Side::Profile);
  addButton(this, tr("W&hole face"), "lookReset");
}

void ViewMenu::addDrawing() {
  addChoices(tr("Drawing st&yle"), "drawingMenu", "faceMesh");
  addChoices(tr("Colour &by"), "colorMenu", "colorBy");
  addButton(this, tr("&Plain skin"), "faceSkin");
}

void ViewMenu::addCurves() {
  addButton(this, tr("Cu&rves on the face"), "faceCurves");
  addButton(this, tr("&Names beside the face"), "faceCurveNames");
  QMenu* curves = addMenu(tr("In the c&urve view"));
  curves->setObjectName("curveMenu");
  addButton(curves, tr("&Points"), "curvePoints");
  addButton(curves, tr("&Neutral curves"), "curveNeutral");
  addButton(curves, tr("&Front only"), "curveFrontOnly");
  addButton(curves, tr("&Link with the face"), "curveLink");
}

void ViewMenu::addDocks(Workspaces* workspaces) {
  QMenu* arrangements = addMenu(tr("&Workspace"));
  arrangements->setObjectName("workspaceMenu");
  workspaces->addTo(arrangements);
  QMenu* docks = addMenu(tr("D&ocks"));
  docks->setObjectName("dockMenu");
  for (QDockWidget* dock : window_->findChildren<QDockWidget*>()) docks->addAction(dock->toggleViewAction());
}

void ViewMenu::addExports() {
  const auto add = [&](const QString& text, const char* name, Exporter* exporter) {
    addAction(text, this, [this, exporter] { ExportDialog::ask(exporter, window_); })->setObjectName(name);
  };
  add(tr("&Export the face..."), "actionExportFace", views_->faceExporter());
  add(tr("Export the &curve view..."), "actionExportCurves", views_->curveExporter());
}

void ViewMenu::addAppearance(MessageBar* messages) {
  addAction(tr("&Messages..."), messages, &MessageBar::showLog)->setObjectName("actionMessages");
  QAction* dark = addAction(tr("&Dark colours"));
  dark->setObjectName("actionDark");
  dark->setCheckable(true);
  dark->setChecked(Theme::current().kind == Theme::Kind::Dark);
  connect(dark, &QAction::toggled, this, [this](bool on) {
    Theme::choose(on ? Theme::Kind::Dark : Theme::Kind::Light, *qApp);
    views_->useTheme();
  });
}

/// Does what a button of the window does, and is ticked and available as that is.
void ViewMenu::addButton(QMenu* menu, const QString& text, const char* name) {
  auto* button = window_->findChild<QAbstractButton*>(name);
  QAction* action = menu->addAction(text, button, &QAbstractButton::click);
  action->setCheckable(button->isCheckable());
  connect(menu, &QMenu::aboutToShow, action, [action, button] {
    action->setEnabled(button->isEnabled());
    action->setChecked(button->isChecked());
  });
}

/// Those of a list of the window, as they are when the menu opens.
void ViewMenu::addChoices(const QString& title, const char* menuName, const char* name) {
  auto* list = window_->findChild<QComboBox*>(name);
  QMenu* menu = addMenu(title);
  menu->setObjectName(menuName);
  const auto fill = [menu, list] {
    menu->clear();
    delete menu->findChild<QActionGroup*>();  // with its choices
    auto* group = new QActionGroup(menu);
    for (int i = 0; i < list->count(); ++i) {
      QAction* choice = list->itemText(i).isEmpty() ? menu->addSeparator() : group->addAction(list->itemText(i));
      choice->setCheckable(!choice->isSeparator());
      choice->setChecked(i == list->currentIndex());
      menu->addAction(choice);
      connect(choice, &QAction::triggered, list, [list, i] { list->setCurrentIndex(i); });
    }
  };
  connect(menu, &QMenu::aboutToShow, list, fill);
}

}  // namespace mien
