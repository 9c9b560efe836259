#pragma once

#include <QMenu>

namespace mien {

class FaceModel;
class RecentFiles;
class SessionDocument;
class StudioWindow;

/// What is opened, saved and closed.
class FileMenu : public QMenu {
  Q_OBJECT
 public:
  FileMenu(StudioWindow* window, SessionDocument* document, RecentFiles* recent);

 private:
  void addSession();
  void addAnimation();
  void addClosing();
  void addTables();
  void chooseSession();

  StudioWindow* window_;
  SessionDocument* document_;
};

}  // namespace mien
