#include "StudioPicture.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <filesystem>

#include "FaceStateText.h"
#include "Failure.h"

namespace mien {

namespace {

constexpr int longestWait = 60000;  // ms

QString studioProgram() {
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  const QString beside = QString::fromStdString((self.parent_path() / "mien-studio").string());
  if (error || !QFile::exists(beside))
    throw FileFailure("mien-studio is not beside this program; the window can only be drawn where it is installed");
  return beside;
}

/// The window as a new user finds it: no settings of this one.
QProcessEnvironment environmentOf(const QTemporaryDir& home) {
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("XDG_CONFIG_HOME", home.path());
  environment.insert("QT_QPA_PLATFORM", "xcb");
  return environment;
}

}  // namespace

QImage studioPicture(const FaceState& state) {
  const QTemporaryDir folder;
  const QString stateFile = folder.filePath("state.json"), pictureFile = folder.filePath("window.png");
  QFile file(stateFile);
  if (!file.open(QIODevice::WriteOnly)) throw FileFailure(stateFile.toStdString() + ": cannot be written");
  file.write(QByteArray::fromStdString(writeFaceState(state)));
  file.close();
  QProcess studio;
  studio.setProcessEnvironment(environmentOf(folder));
  studio.start(studioProgram(), {"--state", stateFile, "--picture", pictureFile});
  const bool ended = studio.waitForFinished(longestWait);
  const QImage picture(pictureFile);
  if (!ended || picture.isNull())
    throw FileFailure("mien-studio drew no picture: " + studio.readAllStandardError().simplified().toStdString());
  return picture.convertToFormat(QImage::Format_RGB888);
}

}  // namespace mien
