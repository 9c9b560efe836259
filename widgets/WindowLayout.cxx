#include "WindowLayout.h"

#include <QCoreApplication>
#include <QMainWindow>
#include <QSettings>

namespace mien {

namespace {

constexpr int version = 1;  // of the docks; one more when their names change
constexpr const char* geometryKey = "window/geometry";
constexpr const char* docksKey = "window/docks";

bool isRemembered() { return !QCoreApplication::organizationName().isEmpty(); }

}  // namespace

void WindowLayout::save(const QMainWindow& window) {
  if (!isRemembered()) return;
  QSettings settings;
  settings.setValue(geometryKey, window.saveGeometry());
  settings.setValue(docksKey, window.saveState(version));
}

void WindowLayout::restore(QMainWindow& window) {
  if (!isRemembered()) return;
  const QSettings settings;
  window.restoreGeometry(settings.value(geometryKey).toByteArray());
  window.restoreState(settings.value(docksKey).toByteArray(), version);
}

}  // namespace mien
