#pragma once

class QMainWindow;

namespace mien {

/// Remembers where the window is and how large from one start to the next.
/// @sa Remembered, Workspaces
class WindowLayout {
 public:
  static void save(const QMainWindow& window);
  static void restore(QMainWindow& window);
};

}  // namespace mien
