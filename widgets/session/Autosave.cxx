#include "Autosave.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QLocale>
#include <QStandardPaths>
#include <QTimer>
#include <nlohmann/json.hpp>

#include "History.h"
#include "Session.h"
#include "SessionFile.h"

namespace mien {

namespace {

QString lockOf(const QString& file) {
  return file + ".lock";
}

/// Stale only when its process has ended, however long ago it was made.
std::unique_ptr<QLockFile> lockFor(const QString& file) {
  auto lock = std::make_unique<QLockFile>(lockOf(file));
  lock->setStaleLockTime(0);
  return lock;
}

}  // namespace

Autosave::Autosave(Session* session, History* history, const QString& folder)
    : QObject(session),
      session_(session),
      folder_(folder),
      file_(QDir(folder).filePath(QString("%1-%2%3")
                                      .arg(QDateTime::currentDateTimeUtc().toString("yyyyMMdd-hhmmss"))
                                      .arg(QCoreApplication::applicationPid())
                                      .arg(SessionFile::ending))),
      timer_(new QTimer(this)) {
  timer_->setSingleShot(true);
  timer_->setInterval(interval);
  connect(timer_, &QTimer::timeout, this, &Autosave::write);
  connect(history, &History::changed, this, [this, history] {
    const bool hasChanged = lock_ || !history->isClean();
    if (hasChanged && !timer_->isActive()) timer_->start();
  });
  findOrphans();
}

Autosave::~Autosave() {
  if (lock_) QFile::remove(file_);
}

QString Autosave::usualFolder() {
  return QDir(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation)).filePath("autosave");
}

void Autosave::findOrphans() {
  const QStringList names = {QString("*") + SessionFile::ending};
  for (const QFileInfo& file : QDir(folder_).entryInfoList(names, QDir::Files, QDir::Time)) {
    auto lock = lockFor(file.filePath());
    if (lock->tryLock(0)) orphans_.push_back({file.filePath(), std::move(lock)});
  }
}

QString Autosave::orphanText() const {
  if (orphans_.empty()) return {};
  return QLocale().toString(QFileInfo(orphans_.front().file).lastModified(), QLocale::ShortFormat);
}

QString Autosave::readOrphan(nlohmann::json& session) const {
  return orphans_.empty() ? QString() : SessionFile::read(orphans_.front().file, session);
}

void Autosave::discardOrphans() {
  for (const Orphan& orphan : orphans_) QFile::remove(orphan.file);
  orphans_.clear();
}

/// Without a place to write to there is none; nobody is troubled with that.
void Autosave::write() {
  if (!lock_) {
    QDir().mkpath(folder_);
    lock_ = lockFor(file_);
    lock_->tryLock(0);
  }
  SessionFile::write(session_->whole(), file_);
}

}  // namespace mien
