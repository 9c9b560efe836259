#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <memory>
#include <nlohmann/json_fwd.hpp>

class QAction;
class QTimer;
class QUndoStack;

namespace mien {

class AnimationPlayer;
class FaceModel;
class Session;

/// Undo and redo of whatever changes the undoable part of a session, without the help of those who change it.
///
/// What changes between pressing and releasing a mouse button is one step, what a shortcut does is one, and so is what
/// the same keys or wheel change within a second. The frames that playing shows are no steps. What follows from a step
/// later, without the user, belongs to it.
class History : public QObject {
  Q_OBJECT
 public:
  static constexpr int together = 1000;  ///< ms

  History(Session* session, FaceModel* model, AnimationPlayer* player);
  ~History() override;

  void record();  ///< what has changed up to now
  void clear();   ///< begins anew with what is shown
  int count() const;
  bool isClean() const;  ///< whether all is as at the last clear() or setClean()
  void setClean();
  void clearAsModified();  ///< the same as clear(), for what was never saved

  QString undoText() const;  ///< what undo() takes back; empty when there is nothing
  QString redoText() const;

 public slots:
  void act();  ///< says that what has just changed is the user's own step, whatever event brought it about
  void undo();
  void redo();

 signals:
  void changed();
  void travels();  ///< before undo() or redo() shows another state

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  class Step;
  enum class Input { None, Mouse, Keys, Command };  ///< Command: a shortcut, or what a key does as it is released
  void note(Input input);
  void followFrame(const nlohmann::json& now);
  void followKnown(const nlohmann::json& now);
  void push(const nlohmann::json& now, bool follows);
  void apply(const nlohmann::json& change);

  Session* session_;
  FaceModel* model_;
  AnimationPlayer* player_;
  QUndoStack* steps_;
  QTimer *idle_, *later_;
  std::unique_ptr<nlohmann::json> present_;
  const nlohmann::json* arriving_ = nullptr;  ///< what a step that is being pushed leads to
  Input input_ = Input::None;                 ///< since the last record()
  bool held_ = false, applying_ = false;
  bool away_ = false;  ///< the user is in another window, perhaps a dialog of the desktop's own
};

}  // namespace mien
