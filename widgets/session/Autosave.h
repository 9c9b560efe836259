#pragma once

#include <QLockFile>
#include <QObject>
#include <QString>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <vector>

class QTimer;

namespace mien {

class History;
class Session;

/// Keeps what has changed in a file of this process until it ends in good order, and finds the files of those that did
/// not. Each has a lock beside it, which ends with its process.
class Autosave : public QObject {
  Q_OBJECT
 public:
  static constexpr int interval = 2000;  ///< ms between a change and its file at most

  /// @param folder  made when it is needed
  Autosave(Session* session, History* history, const QString& folder);
  ~Autosave() override;  ///< takes this process's file away

  static QString usualFolder();  ///< in the user's local data

  bool hasOrphan() const { return !orphans_.empty(); }
  QString orphanText() const;  ///< when its process last wrote it, in words

  /// Reads the newest file of a process that ended without leave. @return nothing, or what is wrong with it
  QString readOrphan(nlohmann::json& session) const;
  void discardOrphans();

 private:
  struct Orphan {
    QString file;
    std::unique_ptr<QLockFile> lock;
  };
  void findOrphans();
  void write();

  Session* session_;
  QString folder_, file_;
  std::unique_ptr<QLockFile> lock_;
  QTimer* timer_;
  std::vector<Orphan> orphans_;  ///< the newest first; locked, so that another start does not offer them too
};

}  // namespace mien
