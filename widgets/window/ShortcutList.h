#pragma once

#include <QString>
#include <vector>

class QWidget;

namespace mien {

/// A command of a window and the keys that give it.
struct ShortcutEntry {
  QString place;    ///< its menu, its dock, or the part of the window that it is in
  QString command;  ///< without its mnemonic
  QString keys;     ///< as the user's system writes them
};

/// The keys of a window, from its menus, its actions, the mnemonics of its buttons and labels, and what its widgets
/// tell of themselves.
std::vector<ShortcutEntry> shortcutsOf(const QWidget& window);

}  // namespace mien
