#include "Session.h"

#include <QFileInfo>
#include <QMainWindow>
#include <QSplitter>
#include <nlohmann/json.hpp>

#include "FaceModel.h"
#include "FaceStateJson.h"
#include "FaceTexture.h"
#include "InlineText.h"
#include "RenderView.h"
#include "WarpMesh.h"
#include "WidgetSettings.h"

namespace mien {

namespace {

using json = nlohmann::json;

constexpr int layoutVersion = 1;  // of docks; one more when their names change

std::string encoded(const QByteArray& bytes) {
  return bytes.toBase64().toStdString();
}

QByteArray decoded(const json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string()
             ? QByteArray::fromBase64(QByteArray::fromStdString(found->get<std::string>()))
             : QByteArray();
}

/// Not under that name any more.
bool isGone(const std::string& file) {
  return !file.empty() && file != "-" && !isInlineText(file) && !QFileInfo::exists(QString::fromStdString(file));
}

/// Leaves out files that are gone.
void leaveOutMissing(FaceState& state) {
  for (std::string* file :
       {&state.curvesFile, &state.fapFile, &state.animationTable, &state.texture, &state.textureMesh}) {
    if (isGone(*file)) file->clear();
  }
  std::string& table = state.deformation.table;  // those that come with Mien have names that are no files
  if (table.find('/') != std::string::npos && isGone(table)) state.deformation = {};
  if (state.texture.empty()) state.textureMesh.clear();
  if (state.fapFile.empty()) state.frame = 0.0;
}

/// Of a mesh that the state holds itself; files are read when the photograph is, off the GUI thread.
std::string faultOfMesh(const FaceState& state) {
  WarpMesh mesh;
  return isInlineText(state.textureMesh) ? readSourceMesh(state.textureMesh, mesh) : std::string();
}

}  // namespace

Session::Session(FaceModel* model, QMainWindow* window) : QObject(window), model_(model), window_(window) {
  setObjectName("session");
}

json Session::undoable() const {
  return {{"face", faceStateJson(model_->state())},
          {"docks", WidgetSettings::read(*window_, WidgetSettings::Of::Undo)}};
}

json Session::shown() const {
  return {{"face", faceStateJson(model_->lastingState())},
          {"docks", WidgetSettings::read(*window_, WidgetSettings::Of::Session)},
          {"window", windowState()}};
}

json Session::whole() {
  json all = shown();
  SessionFiles::keep(all, absent_);
  return all;
}

json Session::cameras() const {
  json all = json::object();
  for (const auto* view : window_->findChildren<const RenderView*>())
    all[view->objectName().toStdString()] = view->sessionState();
  return all;
}

json Session::windowState() const {
  json splitters = json::object();
  for (const auto* splitter : window_->findChildren<QSplitter*>())
    if (!splitter->objectName().isEmpty())
      splitters[splitter->objectName().toStdString()] = encoded(splitter->saveState());
  return {{"geometry", encoded(window_->saveGeometry())},
          {"layout", encoded(window_->saveState(layoutVersion))},
          {"splitters", splitters}};
}

void Session::restoreWindow(const json& window) {
  window_->restoreGeometry(decoded(window, "geometry"));
  window_->restoreState(decoded(window, "layout"), layoutVersion);
  const auto splitters = window.find("splitters");
  if (splitters == window.end() || !splitters->is_object()) return;
  for (const auto& item : splitters->items())
    if (auto* splitter = window_->findChild<QSplitter*>(QString::fromStdString(item.key())))
      splitter->restoreState(decoded(*splitters, item.key().c_str()));
}

QString Session::show(const FaceState& state) {
  QString fault;
  const auto listening = connect(model_, &FaceModel::failed, this, [&fault](const QString& sentence) {
    if (fault.isEmpty()) fault = sentence;
  });
  model_->change([&](FaceState& shown) { shown = state; });
  if (model_->update()) fault.clear();
  disconnect(listening);
  return fault;
}

/// The face first, since widgets follow it; and last, since some of them also change it.
QString Session::restore(const json& session) {
  FaceState state;
  const auto face = session.find("face");
  if (face == session.end()) return tr("the member 'face' is missing");
  const QString unread = QString::fromStdString(readFaceState(*face, state));
  if (!unread.isEmpty()) return unread;
  if (const std::string fault = faultOfMesh(state); !fault.empty()) return QString::fromStdString(fault);
  leaveOutMissing(state);
  const QString fault = show(state);
  if (!fault.isEmpty()) return fault;
  const auto window = session.find("window"), docks = session.find("docks");
  if (window != session.end() && window->is_object()) restoreWindow(*window);
  if (docks != session.end() && docks->is_object()) WidgetSettings::apply(*window_, *docks);
  if (model_->state() != state) show(state);
  return {};
}

QString Session::open(const json& session, const QString& folder) {
  const json found = SessionFiles::found(session, folder);
  std::vector<SessionFiles::Absent> absent = SessionFiles::absentIn(found);
  const QString fault = restore(SessionFiles::without(found, absent));
  if (!fault.isEmpty()) return fault;
  SessionFiles::setRest(shown(), absent);
  absent_ = absent;
  if (!absent.empty())
    emit model_->remarked(tr("Left out, as it is not there any more: %1. The session still names it.")
                              .arg(SessionFiles::names(found, absent).join(", ")),
                          QString());
  return {};
}

}  // namespace mien
