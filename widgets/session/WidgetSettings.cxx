#include "WidgetSettings.h"

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QMetaProperty>
#include <QPointer>
#include <QSlider>
#include <QSpinBox>
#include <QTabBar>
#include <QTabWidget>
#include <QVariant>
#include <nlohmann/json.hpp>
#include <optional>

#include "RenamedChoice.h"
#include "SessionPart.h"

namespace mien {

namespace {

using json = nlohmann::json;
using Of = WidgetSettings::Of;

constexpr const char* outsideDocks = "window";
constexpr const char* awaited = "awaitedChoice";  // of a list that does not hold it yet
constexpr int passes = 5;  // at most: numbers follow choices, and what one dock shows on the face ends what others show

template <class... Classes>
bool isOneOf(const QObject* object) {
  return (qobject_cast<const Classes*>(object) || ...);
}

/// Whether a widget turns pages or is part of the frame around the face.
bool isNavigation(const QObject* object) {
  return isOneOf<QTabBar, QTabWidget, QAction>(object);
}

/// A dialog, be it the desktop's for files, comes and goes without a change.
bool isInDialog(const QObject* object) {
  for (; object; object = object->parent())
    if (qobject_cast<const QDialog*>(object)) return true;
  return false;
}

bool isKept(const QObject* object, Of of) {
  const QString name = object->objectName();
  if (name.isEmpty() || name.startsWith("qt_") || object->property(notInSession).toBool()) return false;
  if (isInDialog(object)) return false;
  if (const auto* part = dynamic_cast<const SessionPart*>(object)) return of == Of::Session || part->isUndoable();
  if (of == Of::Undo && isNavigation(object)) return false;
  if (const auto* button = qobject_cast<const QAbstractButton*>(object)) return button->isCheckable();
  if (const auto* action = qobject_cast<const QAction*>(object))
    return action->isCheckable() && !qobject_cast<QDockWidget*>(action->parent());
  if (const auto* list = qobject_cast<const QComboBox*>(object)) return list->count() > 0;
  return isOneOf<QSpinBox, QDoubleSpinBox, QSlider, QLineEdit, QTabBar, QTabWidget>(object);
}

/// The property that the user changes.
QMetaProperty property(const QObject* object) {
  const QMetaObject* type = object->metaObject();
  if (isOneOf<QTabBar, QTabWidget>(object)) return type->property(type->indexOfProperty("currentIndex"));
  if (isOneOf<QAction>(object)) return type->property(type->indexOfProperty("checked"));
  return type->userProperty();
}

json toJson(const QVariant& value) {
  switch (static_cast<QMetaType::Type>(value.userType())) {
    case QMetaType::Bool:
      return value.toBool();
    case QMetaType::Int:
      return value.toInt();
    case QMetaType::Double:
      return value.toDouble();
    default:
      return value.toString().toStdString();
  }
}

/// @return nothing for a value of another type than the property's
QVariant fromJson(const json& value, int type) {
  if (type == QMetaType::Bool && value.is_boolean()) return value.get<bool>();
  if (type == QMetaType::Int && value.is_number_integer()) return value.get<int>();
  if (type == QMetaType::Double && value.is_number()) return value.get<double>();
  if (type == QMetaType::QString && value.is_string()) return QString::fromStdString(value.get<std::string>());
  return {};
}

/// A list chooses nothing where something else does, as a dock that colours the face: that is set, and not this.
bool choosesNothing(const QObject* object, const json& value) {
  return qobject_cast<const QComboBox*>(object) && value == "";
}

json valueOf(const QObject* object) {
  if (const auto* part = dynamic_cast<const SessionPart*>(object)) return part->sessionState();
  if (const QVariant accepted = object->property(acceptedText); accepted.isValid())
    return accepted.toString().toStdString();
  return toJson(property(object).read(object));
}

/// A text that is not accepted stands in a field that has another value.
bool isSetTo(const QObject* object, const json& value) {
  const auto* text = qobject_cast<const QLineEdit*>(object);
  return value == valueOf(object) && (!text || value == text->text().toStdString());
}

std::string dockOf(const QObject* object) {
  for (const QObject* parent = object; parent; parent = parent->parent())
    if (qobject_cast<const QDockWidget*>(parent)) return parent->objectName().toStdString();
  return outsideDocks;
}

void choose(QComboBox* list, const QString& text) {
  const int row = list->findText(text);
  const bool waits = list->property(awaited).isValid();
  if (waits) list->setProperty(awaited, QString());
  if (row >= 0) return list->setCurrentIndex(row);
  list->setProperty(awaited, text);
  if (waits) return;
  QObject::connect(list, QOverload<int>::of(&QComboBox::activated), list,
                   [list] { list->setProperty(awaited, QString()); });
  QObject::connect(list->model(), &QAbstractItemModel::rowsInserted, list, [list] {
    const QString wanted = list->property(awaited).toString();
    const int found = wanted.isEmpty() ? -1 : list->findText(wanted);
    if (found < 0) return;
    list->setProperty(awaited, QString());
    list->setCurrentIndex(found);
  });
}

void set(QObject* object, const json& value) {
  if (auto* part = dynamic_cast<SessionPart*>(object)) return part->restoreSession(value);
  const QMetaProperty changed = property(object);
  const QVariant wanted = fromJson(value, changed.userType());
  if (!wanted.isValid()) return;
  if (auto* list = qobject_cast<QComboBox*>(object))
    return choose(list, presentChoice(list->objectName(), wanted.toString()));
  changed.write(object, wanted);
  if (auto* text = qobject_cast<QLineEdit*>(object)) emit text->editingFinished();
}

QList<QPointer<QObject>> childrenOf(const QObject& window) {
  QList<QPointer<QObject>> children;
  for (QObject* child : window.findChildren<QObject*>()) children << child;
  return children;
}

}  // namespace

json WidgetSettings::read(const QObject& window, Of of) {
  json settings = json::object();
  for (const QObject* object : window.findChildren<const QObject*>())
    if (isKept(object, of)) settings[dockOf(object)][object->objectName().toStdString()] = valueOf(object);
  return settings;
}

void WidgetSettings::apply(const QObject& window, const json& settings) {
  bool differs = true;
  for (int pass = 0; pass < passes && differs; ++pass) {
    differs = false;
    for (const QPointer<QObject>& object : childrenOf(window)) {
      if (!object) continue;                                              // what is set may take others away
      if (pass > 0 && qobject_cast<QLineEdit*>(object.data())) continue;  // a text that is refused is so again
      const bool isList = qobject_cast<QComboBox*>(object.data()) && !object->objectName().isEmpty();
      if (!isKept(object, Of::Session) && !isList) continue;
      const auto dock = settings.find(dockOf(object));
      if (dock == settings.end() || !dock->is_object()) continue;
      const auto value = dock->find(object->objectName().toStdString());
      if (value == dock->end() || isSetTo(object, *value) || choosesNothing(object, *value)) continue;
      differs = true;
      set(object, *value);
    }
  }
}

const QObject* WidgetSettings::find(const QObject& window, const std::string& dock, const std::string& name) {
  for (const QObject* object : window.findChildren<const QObject*>(QString::fromStdString(name)))
    if (dockOf(object) == dock) return object;
  return nullptr;
}

}  // namespace mien
