#include "FileDialog.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

namespace mien {

namespace {

QString& lastFolder() {
  static QString folder;
  return folder;
}

}  // namespace

void FileDialog::remember(const QString& fileName) {
  if (!fileName.isEmpty()) lastFolder() = QFileInfo(fileName).absolutePath();
}

QString FileDialog::beside(const QString& name) {
  if (QFileInfo(name).isAbsolute() || !QFileInfo(lastFolder()).isDir()) return name;
  return name.isEmpty() ? lastFolder() : QDir(lastFolder()).filePath(name);
}

QString FileDialog::open(QWidget* parent, const QString& title, const QString& filters) {
  const QString name = QFileDialog::getOpenFileName(parent, title, beside(QString()), filters);
  remember(name);
  return name;
}

QString FileDialog::save(QWidget* parent, const QString& title, const QString& suggestion, const QString& filters,
                         const QString& ending) {
  QString name = QFileDialog::getSaveFileName(parent, title, beside(suggestion), filters);
  if (!name.isEmpty() && QFileInfo(name).suffix().isEmpty()) name += ending;
  remember(name);
  return name;
}

}  // namespace mien
