#include "Remembered.h"

#include <QCoreApplication>
#include <QSettings>

namespace mien {

namespace {

bool isActive() {
  return !QCoreApplication::organizationName().isEmpty();
}

}  // namespace

QVariant Remembered::value(const char* key, const QVariant& atFirst) {
  return isActive() ? QSettings().value(key, atFirst) : atFirst;
}

void Remembered::set(const char* key, const QVariant& value) {
  if (isActive()) QSettings().setValue(key, value);
}

}  // namespace mien
