#include "ChangeText.h"

#include <QAbstractButton>
#include <QCoreApplication>
#include <QDockWidget>
#include <QLabel>
#include <QWidget>
#include <map>
#include <nlohmann/json.hpp>

#include "SessionPart.h"
#include "WidgetSettings.h"

namespace mien {

namespace {

using json = nlohmann::json;

constexpr int mostNames = 2;

QString tr(const char* text) {
  return QCoreApplication::translate("ChangeText", text);
}

QStringList keysOf(const json& object) {
  QStringList keys;
  if (object.is_object())
    for (const auto& item : object.items()) keys << QString::fromStdString(item.key());
  return keys;
}

QString listed(const QStringList& names) {
  return names.size() <= mostNames ? names.join(", ") : tr("%1 and %2 more").arg(names[0]).arg(names.size() - 1);
}

QString faceText(const json& face) {
  static const std::map<std::string, QString> words = {
      {"curves", tr("face")},         {"edits", tr("move of a curve")},           {"grid", tr("mesh")},
      {"animation", tr("animation")}, {"animation_table", tr("animation table")}, {"deformation", tr("deformation")},
      {"texture", tr("photograph")}};
  static const std::map<QString, QString> surface = {
      {"scheme", tr("scheme")}, {"a", tr("smoothing a")}, {"harmonics", tr("modes N")}, {"remainder", tr("remainder")}};
  if (face.size() != 1) return tr("face");
  const std::string part = face.begin().key();
  const QStringList keys = keysOf(face.front());
  if (part == "fap_values") return tr("FAP %1").arg(listed(keys));
  if (part == "expressions") return keys.isEmpty() ? tr("expression") : listed(keys);
  if (part == "visemes") return keys.isEmpty() ? tr("viseme") : tr("viseme %1").arg(listed(keys));
  if (part == "surface") return keys.size() == 1 && surface.count(keys[0]) ? surface.at(keys[0]) : tr("surface");
  if (part == "animation" && !keys.contains("file") && keys.size() == 1) return tr("frame");
  const auto found = words.find(part);
  return found == words.end() ? tr("face") : found->second;
}

/// How it is called on the screen; empty when it has no name there.
QString widgetText(const QObject& window, const std::string& dock, const std::string& name) {
  const auto* widget = qobject_cast<const QWidget*>(WidgetSettings::find(window, dock, name));
  if (!widget) return {};
  const auto* button = qobject_cast<const QAbstractButton*>(widget);
  QString text = button && !button->text().isEmpty() ? button->text() : widget->accessibleName();
  for (const auto* label : window.findChildren<QLabel*>())
    if (text.isEmpty() && label->buddy() == widget) text = label->text();
  return text.remove('&');
}

/// What other widgets change with it is its consequence.
QString partText(const QObject& window, const std::string& dock, const std::string& name) {
  const auto* part = dynamic_cast<const SessionPart*>(WidgetSettings::find(window, dock, name));
  return part ? part->changeName() : QString();
}

QString dockText(const QObject& window, const json& docks) {
  const std::string dock = docks.begin().key();
  const auto* frame = window.findChild<QDockWidget*>(QString::fromStdString(dock));
  const QString title = frame ? frame->windowTitle() : tr("view");
  const QStringList keys = keysOf(docks.front());
  QString text;
  for (const auto& nameOf : {partText, widgetText})
    for (const QString& key : keys)
      if (text.isEmpty()) text = nameOf(window, dock, key.toStdString());
  if (text.isEmpty()) return title;
  return frame ? tr("%1: %2").arg(title, text) : text;
}

}  // namespace

QString changeText(const json& change, const QObject& window) {
  const auto face = change.find("face"), docks = change.find("docks");
  if (face != change.end() && face->is_object() && !face->empty()) return faceText(*face);
  if (docks != change.end() && docks->is_object() && !docks->empty()) return dockText(window, *docks);
  return tr("change");
}

}  // namespace mien
