#pragma once

class QMainWindow;

namespace mien {

/// Remembers where the docks are from one start to the next.
/// @sa Remembered
class WindowLayout {
 public:
  static void save(const QMainWindow& window);
  static void restore(QMainWindow& window);  ///< a layout of another version is left alone
};

}  // namespace mien
