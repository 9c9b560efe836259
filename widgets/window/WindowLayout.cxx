#include "WindowLayout.h"

#include <QMainWindow>

#include "Remembered.h"

namespace mien {

namespace {

constexpr int version = 1;  // of the docks; one more when their names change
constexpr const char* geometryKey = "window/geometry";
constexpr const char* docksKey = "window/docks";

}  // namespace

void WindowLayout::save(const QMainWindow& window) {
  Remembered::set(geometryKey, window.saveGeometry());
  Remembered::set(docksKey, window.saveState(version));
}

void WindowLayout::restore(QMainWindow& window) {
  window.restoreGeometry(Remembered::value(geometryKey, QByteArray()).toByteArray());
  window.restoreState(Remembered::value(docksKey, QByteArray()).toByteArray(), version);
}

}  // namespace mien
