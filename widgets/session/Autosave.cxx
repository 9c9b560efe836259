#include "Autosave.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QLocale>
#include <QStandardPaths>
#include <QTimer>
#include <nlohmann/json.hpp>

#include "Session.h"
#include "SessionFile.h"

namespace mien {

namespace {

constexpr const char *member = "autosave", *asideEnding = ".damaged";

QString lockOf(const QString& file) {
  return file + ".lock";
}

/// Stale only when its process has ended, however long ago it was made.
std::unique_ptr<QLockFile> lockFor(const QString& file) {
  auto lock = std::make_unique<QLockFile>(lockOf(file));
  lock->setStaleLockTime(0);
  return lock;
}

/// What its own member says; empty when it does not.
QString textOf(const nlohmann::json& session, const char* name) {
  const auto own = session.find(member);
  if (own == session.end() || !own->is_object()) return {};
  const auto text = own->find(name);
  return text != own->end() && text->is_string() ? QString::fromStdString(text->get<std::string>()) : QString();
}

}  // namespace

Autosave::Autosave(Session* session, const QString& folder)
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
  findOrphans();
}

Autosave::~Autosave() {
  putAway();
}

void Autosave::putAway() {
  timer_->stop();
  if (lock_) QFile::remove(file_);
  lock_.reset();
}

void Autosave::setDocument(const QString& fileName, const QString& stamp) {
  document_ = fileName;
  stamp_ = stamp;
}

void Autosave::follow(bool isModified) {
  if (!isModified) return putAway();
  if (!timer_->isActive()) timer_->start();
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
  putDamagedAside();
}

void Autosave::putDamagedAside() {
  std::vector<Orphan> whole;
  for (; !orphans_.empty();) {
    nlohmann::json session;
    const QString damage = readOrphan(session);
    if (damage.isEmpty()) {
      whole.push_back(std::move(orphans_.front()));
      orphans_.erase(orphans_.begin());
      continue;
    }
    const QString aside = orphans_.front().file + asideEnding;
    putAside();
    damage_ << tr("%1. It is kept as %2.").arg(damage, QDir::toNativeSeparators(aside));
  }
  orphans_ = std::move(whole);
}

QString Autosave::orphanText() const {
  if (orphans_.empty()) return {};
  nlohmann::json session;
  readOrphan(session);
  const QString name = QFileInfo(documentOf(session)).fileName();
  const QString time =
      QLocale::system().toString(QFileInfo(orphans_.front().file).lastModified(), QLocale::ShortFormat);
  return name.isEmpty()
             ? tr("Mien Studio ended unexpectedly. What it showed last, %1, was kept.").arg(time)
             : tr("Mien Studio ended unexpectedly. What was changed in %1 until %2 was kept.").arg(name, time);
}

QString Autosave::readOrphan(nlohmann::json& session) const {
  return orphans_.empty() ? QString() : SessionFile::read(orphans_.front().file, session);
}

void Autosave::discardOrphan() {
  if (orphans_.empty()) return;
  QFile::remove(orphans_.front().file);
  orphans_.erase(orphans_.begin());
}

/// One that cannot be renamed would be told of at every start.
void Autosave::putAside() {
  if (orphans_.empty()) return;
  const QString file = orphans_.front().file;
  QFile::remove(file + asideEnding);
  if (!QFile::rename(file, file + asideEnding)) QFile::remove(file);
  orphans_.erase(orphans_.begin());
}

QString Autosave::documentOf(const nlohmann::json& session) {
  return textOf(session, "document");
}

QString Autosave::stampOf(const nlohmann::json& session) {
  return textOf(session, "stamp");
}

/// Without a place to write to there is none; nobody is troubled with that.
void Autosave::write() {
  if (!lock_) {
    QDir().mkpath(folder_);
    lock_ = lockFor(file_);
    lock_->tryLock(0);
  }
  nlohmann::json session = session_->whole();
  session[member] = {{"document", document_.toStdString()}, {"stamp", stamp_.toStdString()}};
  SessionFile::write(session, file_);
}

}  // namespace mien
