#pragma once

#include <QObject>

class QMainWindow;

namespace mien {

class AnimationPlayer;
class Autosave;
class FaceModel;
class History;
class RecentFiles;
class SessionDocument;

/// All that keeps what a window shows: its history, its file, the files opened last and, in a program with a name, the
/// file that outlasts a crash.
class SessionKeeper : public QObject {
  Q_OBJECT
 public:
  SessionKeeper(FaceModel* model, AnimationPlayer* player, QMainWindow* window);

  void keep();   ///< what has changed beside the document itself, such as the workspace
  void begin();  ///< once the window is whole: what it shows is a new session, with nothing to undo

  History* history() const { return history_; }
  SessionDocument* document() const { return document_; }
  RecentFiles* recent() const { return recent_; }
  Autosave* autosave() const { return autosave_; }  ///< nullptr in a program without a name, such as a test

 private:
  History* history_;
  SessionDocument* document_;
  RecentFiles* recent_;
  Autosave* autosave_ = nullptr;
};

}  // namespace mien
