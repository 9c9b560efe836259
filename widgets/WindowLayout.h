#pragma once

class QMainWindow;

namespace mien {

/// Remembers where the docks are from one start to the next: in the user's settings, once the program has named its
/// organisation; tests and tools, which do not, always see the first start.
class WindowLayout {
 public:
  static void save(const QMainWindow& window);
  static void restore(QMainWindow& window);  ///< a layout of another version is left alone
};

}  // namespace mien
