#pragma once

#include <QDateTime>
#include <QString>

namespace mien {

/// One sentence that was said to the user.
struct Message {
  QDateTime time;
  bool isError;
  QString sentence, details;
};

}  // namespace mien
