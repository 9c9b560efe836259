#include "RecentFiles.h"

#include <QFileInfo>

#include "FileDialog.h"
#include "Remembered.h"

namespace mien {

namespace {

constexpr const char* key = "files/recent";

}  // namespace

RecentFiles::RecentFiles(QObject* parent)
    : QObject(parent), files_(Remembered::value(key, QStringList()).toStringList()) {
  if (!files_.isEmpty()) FileDialog::remember(files_.front());
}

void RecentFiles::add(const QString& fileName) {
  const QString file = QFileInfo(fileName).absoluteFilePath();
  FileDialog::remember(file);
  files_.removeAll(file);
  files_.prepend(file);
  while (files_.size() > most) files_.removeLast();
  keep();
}

void RecentFiles::remove(const QString& fileName) {
  files_.removeAll(fileName);
  keep();
}

void RecentFiles::clear() {
  files_.clear();
  keep();
}

void RecentFiles::keep() {
  Remembered::set(key, files_);
  emit changed();
}

}  // namespace mien
