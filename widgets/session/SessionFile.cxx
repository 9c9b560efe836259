#include "SessionFile.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QFileInfo>
#include <nlohmann/json.hpp>

#include "SessionText.h"
#include "TextFileReader.h"
#include "WholeFile.h"

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
  const std::string fault = WholeFile::write(fileName.toStdString(), writeSession(session));
  return fault.empty() ? QString() : QFileInfo(fileName).fileName() + ": " + QString::fromStdString(fault);
}

QString SessionFile::stampOf(const QString& fileName) {
  const QFileInfo file(fileName);
  if (fileName.isEmpty() || !file.exists()) return {};
  return QString("%1 %2").arg(file.lastModified().toMSecsSinceEpoch()).arg(file.size());
}

}  // namespace mien
