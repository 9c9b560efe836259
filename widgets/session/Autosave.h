#pragma once

#include <QLockFile>
#include <QObject>
#include <QString>
#include <QStringList>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <vector>

class QTimer;

namespace mien {

class Session;

/// Keeps what has changed in a file of this process until it ends in good order, and finds the files of those that did
/// not. Each has a lock beside it, which ends with its process. The file is a session with the member
/// `autosave`: {"document": the file whose session it is, or empty, "stamp": SessionFile::stampOf() when it was read}.
class Autosave : public QObject {
  Q_OBJECT
 public:
  static constexpr int interval = 2000;  ///< ms between a change and its file at most

  /// @param folder  made when it is needed
  Autosave(Session* session, const QString& folder);
  ~Autosave() override;  ///< takes this process's file away

  static QString usualFolder();  ///< in the user's local data

  bool hasOrphan() const { return !orphans_.empty(); }
  QString orphanText() const;  ///< whose session it is and when its process last wrote it, in a sentence

  /// Reads the newest file of a process that ended without leave. @return nothing, or what is wrong with it
  QString readOrphan(nlohmann::json& session) const;
  void discardOrphan();  ///< the next one is the newest then
  void putAside();       ///< renames the newest, so that it is not offered again and a later version may read it

  /// What was wrong with files that were found damaged, and how they are called now: a line for each, told once.
  QString damage() const { return damage_.join('\n'); }

  /// The file whose session this is; empty: none.
  static QString documentOf(const nlohmann::json& session);

  /// How that file was when it was opened or saved; empty: not known.
  static QString stampOf(const nlohmann::json& session);

 public slots:
  void setDocument(const QString& fileName, const QString& stamp);

  /// After each change. Nothing is kept of what is not modified.
  void follow(bool isModified);

 private:
  struct Orphan {
    QString file;
    std::unique_ptr<QLockFile> lock;
  };
  void findOrphans();
  void putDamagedAside();
  void write();
  void putAway();

  Session* session_;
  QString folder_, file_, document_, stamp_;
  QStringList damage_;
  std::unique_ptr<QLockFile> lock_;
  QTimer* timer_;
  std::vector<Orphan> orphans_;  ///< the newest first; locked, so that another start does not offer them too
};

}  // namespace mien
