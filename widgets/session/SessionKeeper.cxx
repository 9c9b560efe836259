#include "SessionKeeper.h"

#include <QCoreApplication>
#include <QMainWindow>

#include "Autosave.h"
#include "History.h"
#include "RecentFiles.h"
#include "Session.h"
#include "SessionDocument.h"

namespace mien {

SessionKeeper::SessionKeeper(FaceModel* model, AnimationPlayer* player, QMainWindow* window) : QObject(window) {
  auto* session = new Session(model, window);
  history_ = new History(session, model, player);
  document_ = new SessionDocument(session, history_, model, window);
  recent_ = new RecentFiles(this);
  if (!QCoreApplication::organizationName().isEmpty()) autosave_ = new Autosave(session, Autosave::usualFolder());
  connect(document_, &SessionDocument::opened, recent_, &RecentFiles::add);
  connect(document_, &SessionDocument::saved, recent_, &RecentFiles::add);
  if (!autosave_) return;
  connect(document_, &SessionDocument::named, autosave_, &Autosave::setDocument);
  connect(document_, &SessionDocument::changed, autosave_, &Autosave::follow);
}

void SessionKeeper::keep() {
  if (autosave_) autosave_->follow(document_->isModified());
}

void SessionKeeper::begin() {
  history_->clear();
  document_->rememberStart();
}

}  // namespace mien
