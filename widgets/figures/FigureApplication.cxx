#include "FigureApplication.h"

#include <QGuiApplication>

#include <clocale>

namespace mien {

namespace {

// Qt keeps references to these as long as the application lives.
char programName[] = "mien";
char platformOption[] = "-platform";
char platformName[] = "offscreen";
char* arguments[] = {programName, platformOption, platformName, nullptr};
int argumentCount = 3;

}  // namespace

FigureApplication::FigureApplication() {
  if (QCoreApplication::instance()) return;
  own_ = std::make_unique<QGuiApplication>(argumentCount, arguments);
  std::setlocale(LC_NUMERIC, "C");  // Qt has set the user's, in which decimals may have a comma
}

FigureApplication::~FigureApplication() = default;

}  // namespace mien
