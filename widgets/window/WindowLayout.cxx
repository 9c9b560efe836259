#include "WindowLayout.h"

#include <QMainWindow>

#include "Remembered.h"

namespace mien {

namespace {

constexpr const char* geometryKey = "window/geometry";

}  // namespace

void WindowLayout::save(const QMainWindow& window) {
  Remembered::set(geometryKey, window.saveGeometry());
}

void WindowLayout::restore(QMainWindow& window) {
  window.restoreGeometry(Remembered::value(geometryKey, QByteArray()).toByteArray());
}

}  // namespace mien
