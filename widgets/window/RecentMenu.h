#pragma once

#include <QMenu>

namespace mien {

class RecentFiles;
class StudioWindow;

/// The files that were opened or saved last.
class RecentMenu : public QMenu {
  Q_OBJECT
 public:
  RecentMenu(StudioWindow* window, RecentFiles* files);

 private:
  void fill();
  void open(const QString& fileName);

  StudioWindow* window_;
  RecentFiles* files_;
};

}  // namespace mien
