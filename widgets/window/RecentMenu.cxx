#include "RecentMenu.h"

#include <QFileInfo>

#include "FaceModel.h"
#include "RecentFiles.h"
#include "StudioWindow.h"

namespace mien {

RecentMenu::RecentMenu(StudioWindow* window, RecentFiles* files)
    : QMenu(tr("Open &recent"), window), window_(window), files_(files) {
  setObjectName("recentMenu");
  setToolTipsVisible(true);
  connect(files_, &RecentFiles::changed, this, &RecentMenu::fill, Qt::QueuedConnection);  // its own actions change it
  fill();
}

void RecentMenu::fill() {
  clear();
  int number = 0;
  for (const QString& file : files_->files()) {
    QString name = QFileInfo(file).fileName();
    QAction* action = addAction(tr("&%1 %2").arg(++number % RecentFiles::most).arg(name.replace("&", "&&")), window_,
                                [this, file] { open(file); });
    action->setToolTip(file);
  }
  addSeparator();
  addAction(tr("&Clear this list"), files_, &RecentFiles::clear)->setObjectName("actionClearRecent");
  menuAction()->setEnabled(number > 0);
}

void RecentMenu::open(const QString& fileName) {
  if (QFileInfo::exists(fileName)) {
    window_->openFile(fileName);
    return;
  }
  files_->remove(fileName);
  emit window_->model().failed(
      tr("%1 is not there any more; it was taken out of the list.").arg(QFileInfo(fileName).fileName()), fileName);
}

}  // namespace mien
