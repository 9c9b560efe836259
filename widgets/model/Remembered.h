#pragma once

#include <QVariant>

namespace mien {

/// What the application keeps from one start to the next, in the user's settings: once the program has named its
/// organisation; tests and tools, which do not, always see the first start.
class Remembered {
 public:
  static QVariant value(const char* key, const QVariant& atFirst);
  static void set(const char* key, const QVariant& value);
};

}  // namespace mien
