#include "EditMenu.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>

#include "CommandCopy.h"
#include "History.h"

namespace mien {

namespace {

/// A text that is being written undoes its own letters first.
bool keepsUndo(const QObject* watched, bool isUndo) {
  const auto* text = qobject_cast<const QLineEdit*>(watched);
  if (!text || qobject_cast<const QAbstractSpinBox*>(text->parent())) return false;
  return isUndo ? text->isUndoAvailable() : text->isRedoAvailable();
}

}  // namespace

EditMenu::EditMenu(History* history, FaceModel* model, const ViewArea* views, QWidget* window)
    : QMenu(tr("&Edit"), window),
      history_(history),
      undo_(addAction(tr("&Undo"), history, &History::undo)),
      redo_(addAction(tr("&Redo"), history, &History::redo)) {
  setObjectName("editMenu");
  undo_->setObjectName("actionUndo");
  undo_->setShortcut(Qt::CTRL | Qt::Key_Z);
  redo_->setObjectName("actionRedo");
  redo_->setShortcuts({Qt::CTRL | Qt::SHIFT | Qt::Key_Z, Qt::CTRL | Qt::Key_Y});
  addSeparator();
  addAction(tr("Copy as mien &command"), this, [model, views] {
    copyCommand(model, *views);
  })->setObjectName("actionCopyCommand");
  connect(history, &History::changed, this, &EditMenu::follow);
  qApp->installEventFilter(this);
  follow();
}

void EditMenu::follow() {
  const QString undone = history_->undoText(), redone = history_->redoText();
  undo_->setText(undone.isEmpty() ? tr("&Undo") : tr("&Undo %1").arg(undone));
  redo_->setText(redone.isEmpty() ? tr("&Redo") : tr("&Redo %1").arg(redone));
  undo_->setEnabled(!undone.isEmpty());
  redo_->setEnabled(!redone.isEmpty());
}

bool EditMenu::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride) return false;
  const auto* key = static_cast<QKeyEvent*>(event);
  const bool isUndo = key->matches(QKeySequence::Undo), isRedo = key->matches(QKeySequence::Redo);
  if (!(isUndo || isRedo) || keepsUndo(watched, isUndo)) return false;
  event->ignore();
  return true;
}

}  // namespace mien
