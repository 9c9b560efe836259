#include "BundledFile.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace mien {

QString bundledFile(const QString& name) {
  const QString installed = QCoreApplication::applicationDirPath() + "/../share/mien/" + name;
  return QFileInfo::exists(installed) ? installed : QString(MIEN_SOURCE_DATA_DIR "/") + name;
}

}  // namespace mien
