#include "SessionDocument.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QMessageBox>
#include <nlohmann/json.hpp>

#include "Autosave.h"
#include "FaceModel.h"
#include "FileDialog.h"
#include "History.h"
#include "Session.h"
#include "SessionFile.h"
#include "SessionPart.h"

namespace mien {

namespace {

using json = nlohmann::json;

SessionDocument::Answer ask(QWidget* window, const QString& name) {
  const auto answer =
      QMessageBox::question(window, SessionDocument::tr("Save the session?"),
                            SessionDocument::tr("%1 has changed. Without saving, the changes are lost.")
                                .arg(name.isEmpty() ? SessionDocument::tr("The session") : QFileInfo(name).fileName()),
                            QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  return answer == QMessageBox::Save      ? SessionDocument::Answer::Save
         : answer == QMessageBox::Discard ? SessionDocument::Answer::Discard
                                          : SessionDocument::Answer::Cancel;
}

bool warn(QWidget* window, const QString& name) {
  return QMessageBox::warning(window, SessionDocument::tr("Replace the file?"),
                              SessionDocument::tr("%1 has been written since it was opened here, perhaps by another "
                                                  "window. Saving replaces what is in it now.")
                                  .arg(QFileInfo(name).fileName()),
                              QMessageBox::Save | QMessageBox::Cancel, QMessageBox::Cancel) == QMessageBox::Save;
}

}  // namespace

SessionDocument::SessionDocument(Session* session, History* history, FaceModel* model, QWidget* window)
    : QObject(window),
      session_(session),
      history_(history),
      model_(model),
      window_(window),
      cameras_(std::make_unique<json>(session->cameras())) {
  if (!QCoreApplication::organizationName().isEmpty()) {
    question_ = [this] { return ask(window_, file_); };
    warning_ = [this] { return warn(window_, file_); };
  }
  connect(history_, &History::changed, this, &SessionDocument::showTitle);
  showTitle();
}

SessionDocument::~SessionDocument() = default;

bool SessionDocument::isModified() const {
  if (!history_->isClean()) return true;
  const json now = session_->cameras();
  for (const auto& view : now.items())
    if (const auto before = cameras_->find(view.key()); before != cameras_->end() && *before != view.value())
      return true;
  return false;
}

/// The desktop adds the program's name.
void SessionDocument::showTitle() {
  const QString name = file_.isEmpty() ? tr("New session") : QFileInfo(file_).fileName();
  window_->setWindowTitle((recovered_ ? tr("%1 (recovered)").arg(name) : name) + "[*]");
  const bool modified = isModified();
  window_->setWindowModified(modified);
  emit changed(modified);
}

void SessionDocument::take(const QString& fileName) {
  file_ = fileName.isEmpty() ? QString() : QFileInfo(fileName).absoluteFilePath();
  stamp_ = SessionFile::stampOf(file_);
  recovered_ = false;
  *cameras_ = session_->cameras();
  emit named(file_, stamp_);
  showTitle();
}

/// Docks stay where the user put them, in the workspace that is open.
void SessionDocument::rememberStart() {
  start_ = std::make_unique<json>(session_->whole());
  start_->erase("window");
  for (json& dock : start_->at("docks")) dock.erase(arrangementPart);
  *cameras_ = session_->cameras();
}

/// A view that is made, or goes, is the consequence of something else.
void SessionDocument::followCameras() {
  const json now = session_->cameras();
  for (const auto& view : now.items())
    if (!cameras_->contains(view.key())) (*cameras_)[view.key()] = view.value();
  showTitle();
}

void SessionDocument::startNew() {
  if (!start_ || !mayClose() || !show(*start_, tr("A new session"))) return;
  history_->clear();
  take(QString());
}

bool SessionDocument::show(const nlohmann::json& session, const QString& name, const QString& folder) {
  const QString fault = session_->open(session, folder);
  return fault.isEmpty() || refuse(tr("%1 cannot be opened: %2").arg(name, fault));
}

bool SessionDocument::refuse(const QString& fault) {
  emit model_->failed(fault, tr("The face is as it was before."));
  return false;
}

bool SessionDocument::open(const QString& fileName) {
  nlohmann::json session;
  const QString fault = SessionFile::read(fileName, session);
  if (!fault.isEmpty()) return refuse(fault + tr("; nothing was changed"));
  const QFileInfo file(fileName);
  if (!show(session, file.fileName(), file.absolutePath())) return false;
  history_->clear();
  take(fileName);
  emit opened(file_);
  return true;
}

bool SessionDocument::recover(const nlohmann::json& session, const QString& fault) {
  if (!fault.isEmpty()) return refuse(fault);
  if (!show(session, tr("What was kept"))) return false;
  history_->clearAsModified();
  take(Autosave::documentOf(session));
  recovered_ = true;
  if (const QString stamp = Autosave::stampOf(session); !stamp.isEmpty()) stamp_ = stamp;
  emit named(file_, stamp_);
  showTitle();
  return true;
}

bool SessionDocument::save(const QString& fileName) {
  history_->record();
  nlohmann::json session = session_->whole();
  session["folder"] = QFileInfo(fileName).absolutePath().toStdString();
  const QString fault = SessionFile::write(session, fileName);
  if (!fault.isEmpty()) {
    emit model_->failed(fault, fileName);
    return false;
  }
  history_->setClean();
  take(fileName);
  emit model_->remarked(tr("%1 was written.").arg(QFileInfo(fileName).fileName()), fileName);
  emit saved(file_);
  return true;
}

bool SessionDocument::save() {
  if (file_.isEmpty()) return saveAs();
  return mayReplace() && save(file_);
}

bool SessionDocument::mayReplace() {
  const QString now = SessionFile::stampOf(file_);
  return now.isEmpty() || now == stamp_ || !warning_ || warning_();
}

bool SessionDocument::saveAs() {
  const QString name =
      FileDialog::save(window_, tr("Save the session"), file_.isEmpty() ? QString("face") + SessionFile::ending : file_,
                       tr("Sessions (*%1)").arg(SessionFile::ending), SessionFile::ending);
  return !name.isEmpty() && save(name);
}

bool SessionDocument::mayClose() {
  if (!isModified() || !question_) return true;
  const Answer answer = question_();
  return answer == Answer::Discard || (answer == Answer::Save && save());
}

}  // namespace mien
