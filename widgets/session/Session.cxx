#include "Session.h"

#include <QFileInfo>
#include <QMainWindow>
#include <QSplitter>
#include <nlohmann/json.hpp>

#include "FaceModel.h"
#include "FaceStateJson.h"
#include "RenderView.h"
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
  return !file.empty() && file != "-" && !QFileInfo::exists(QString::fromStdString(file));
}

/// Leaves out files that are gone. @return their names
QStringList leaveOutMissing(FaceState& state) {
  QStringList missing;
  for (std::string* file :
       {&state.curvesFile, &state.fapFile, &state.animationTable, &state.texture, &state.textureMesh}) {
    if (!isGone(*file)) continue;
    missing << QString::fromStdString(*file);
    file->clear();
  }
  if (state.texture.empty()) state.textureMesh.clear();
  if (state.fapFile.empty()) state.frame = 0.0;
  return missing;
}

}  // namespace

Session::Session(FaceModel* model, QMainWindow* window) : QObject(window), model_(model), window_(window) {
  setObjectName("session");
}

json Session::undoable() const {
  return {{"face", faceStateJson(model_->state())},
          {"docks", WidgetSettings::read(*window_, WidgetSettings::Of::Undo)}};
}

json Session::whole() const {
  return {{"face", faceStateJson(model_->lastingState())},
          {"docks", WidgetSettings::read(*window_, WidgetSettings::Of::Session)},
          {"window", windowState()}};
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
  const QStringList missing = leaveOutMissing(state);
  const QString fault = show(state);
  if (!fault.isEmpty()) return fault;
  const auto window = session.find("window"), docks = session.find("docks");
  if (window != session.end() && window->is_object()) restoreWindow(*window);
  if (docks != session.end() && docks->is_object()) WidgetSettings::apply(*window_, *docks);
  if (model_->state() != state) show(state);
  if (!missing.isEmpty())
    emit model_->remarked(tr("Left out, as it is not there any more: %1").arg(missing.join(", ")), QString());
  return {};
}

}  // namespace mien
