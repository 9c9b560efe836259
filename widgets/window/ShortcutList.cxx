#include "ShortcutList.h"

#include <QAbstractButton>
#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QSet>
#include <QVariant>

#include "OwnKeys.h"

namespace mien {

namespace {

using Entries = std::vector<ShortcutEntry>;

QString plain(QString text) {
  return text.remove("...").replace("&&", "\1").remove('&').replace('\1', '&');
}

QString keysOf(const QList<QKeySequence>& sequences) {
  QStringList texts;
  for (const QKeySequence& sequence : sequences) texts << sequence.toString(QKeySequence::NativeText);
  return texts.join(", ");
}

/// The dock that a widget is in, or what the window calls the part of it around the face.
QString placeOf(const QWidget* widget) {
  for (; widget; widget = widget->parentWidget())
    if (const auto* dock = qobject_cast<const QDockWidget*>(widget)) return plain(dock->windowTitle());
  return QObject::tr("Window");
}

void addActions(const QMenu& menu, const QString& place, QSet<const QAction*>& told, Entries& entries) {
  for (const QAction* action : menu.actions()) {
    if (action->menu()) {
      addActions(*action->menu(), place, told, entries);
    } else if (!action->shortcuts().isEmpty()) {
      told.insert(action);
      entries.push_back({place, plain(action->text()), keysOf(action->shortcuts())});
    }
  }
}

void addMnemonic(const QWidget& widget, const QString& text, Entries& entries) {
  const QKeySequence mnemonic = QKeySequence::mnemonic(text);
  if (!mnemonic.isEmpty()) entries.push_back({placeOf(&widget), plain(text), keysOf({mnemonic})});
}

void addOwn(const QWidget& widget, QSet<QString>& told, Entries& entries) {
  for (const QString& line : widget.property(ownKeys).toStringList()) {
    const QString place = placeOf(&widget), keys = line.section(": ", 0, 0);
    if (told.contains(place + line)) continue;
    told.insert(place + line);
    entries.push_back({place, line.section(": ", 1), keys});
  }
}

}  // namespace

std::vector<ShortcutEntry> shortcutsOf(const QWidget& window) {
  Entries entries;
  QSet<const QAction*> told;
  QSet<QString> toldKeys;
  const auto* main = qobject_cast<const QMainWindow*>(&window);
  for (const QAction* action : main ? main->menuBar()->actions() : QList<QAction*>()) {
    const QString place = plain(action->text());
    entries.push_back({place, QObject::tr("The menu %1").arg(place), keysOf({QKeySequence::mnemonic(action->text())})});
    if (action->menu()) addActions(*action->menu(), place, told, entries);
  }
  for (const auto* action : window.findChildren<const QAction*>())
    if (!action->shortcuts().isEmpty() && !told.contains(action))
      entries.push_back({placeOf(qobject_cast<const QWidget*>(action->parent())), plain(action->text()),
                         keysOf(action->shortcuts())});
  for (const auto* button : window.findChildren<const QAbstractButton*>())
    addMnemonic(*button, button->text(), entries);
  for (const auto* label : window.findChildren<const QLabel*>())
    if (label->buddy()) addMnemonic(*label, label->text(), entries);
  for (const auto* widget : window.findChildren<const QWidget*>()) addOwn(*widget, toldKeys, entries);
  return entries;
}

}  // namespace mien
