#pragma once

#include <QMainWindow>

#include "FaceView.h"
#include "FileKind.h"

namespace mien {

class AnimationPlayer;
class CurveView;
class FaceModel;
class FileOpener;
class History;
class LaboratoryDocks;
class LiveStream;
class MessageBar;
class SessionDocument;
class SessionKeeper;
class ViewArea;
class Workspaces;

/// The main window of Mien Studio: it puts the widgets in their places and knows the menus.
class StudioWindow : public QMainWindow {
  Q_OBJECT
 public:
  StudioWindow();
  ~StudioWindow() override;

  FaceModel& model() { return *model_; }
  AnimationPlayer& player() { return *player_; }
  History& history();
  SessionDocument& document();

 public slots:
  /// Takes over whatever a file holds, as its content tells: an animation, a table, boundary curves, a scan, a
  /// photograph, a session; of other files the message bar says what they are for. @return whether it was taken over
  bool openFile(const QString& fileName);
  bool openAnimation(const QString& fileName);  ///< the message bar says what is wrong with a file that has a fault
  void playStream(int descriptor);              ///< a .fap stream that is still being written; 0 is standard input
  bool openAnimationTable(const QString& fileName);  ///< a user's own .json; empty: the one compiled in
  void chooseAnimation();
  void chooseAnimationTable();
  void playDemonstration();  ///< the animation that comes with the application
  void resetAll();           ///< the neutral face, without expression and animation

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  QWidget* centre();
  void addDocks();
  void addDock(const QString& name, const QString& title, QWidget* panel);
  bool openAs(FileKind kind, const QString& fileName);
  void addMenus();
  void addFaceMenu();

  FaceModel* model_;
  AnimationPlayer* player_;
  FaceView* face_;
  CurveView* curves_;
  ViewArea* views_;
  MessageBar* messages_;
  LaboratoryDocks* laboratory_;
  FileOpener* opener_;
  Workspaces* workspaces_;
  SessionKeeper* keeper_;
  LiveStream* stream_ = nullptr;
};

}  // namespace mien
