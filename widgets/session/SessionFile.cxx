#include "SessionFile.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QSaveFile>
#include <nlohmann/json.hpp>

#include "SessionText.h"
#include "TextFileReader.h"

namespace mien {

namespace {

QString sentence(const char* text) {
  return QCoreApplication::translate("SessionFile", text);
}

}  // namespace

QString SessionFile::read(const QString& fileName, nlohmann::json& session) {
  const QString name = QFileInfo(fileName).fileName();
  std::string text;
  std::string fault = readTextFile(fileName.toStdString(), largestSessionText, text, "session");
  if (fault.empty()) fault = readSession(text, session);
  return fault.empty() ? QString() : sentence("%1 cannot be opened: %2").arg(name, QString::fromStdString(fault));
}

QString SessionFile::write(const nlohmann::json& session, const QString& fileName) {
  const QByteArray text = QByteArray::fromStdString(writeSession(session));
  QSaveFile file(fileName);
  if (file.open(QIODevice::WriteOnly) && file.write(text) == text.size() && file.commit()) return {};
  return sentence("%1 cannot be written: %2; choose a folder that exists and may be written to")
      .arg(QFileInfo(fileName).fileName(), file.errorString());
}

}  // namespace mien
