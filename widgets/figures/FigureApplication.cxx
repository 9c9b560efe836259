#include "FigureApplication.h"

#include <QGuiApplication>
#include <algorithm>
#include <clocale>
#include <iostream>
#include <iterator>

namespace mien {

namespace {

// Qt keeps references to these as long as the application lives, and takes out what it has understood.
char programName[] = "mien";
char platformOption[] = "-platform";
char platformName[] = "offscreen";
char* arguments[4];
int argumentCount;

void setArguments() {
  argumentCount = 3;
  char* const all[] = {programName, platformOption, platformName, nullptr};
  std::copy(std::begin(all), std::end(all), arguments);
}

/// Without a session Qt complains about XDG_RUNTIME_DIR, which nothing here needs.
void swallow(QtMsgType type, const QMessageLogContext&, const QString& text) {
  if (type == QtCriticalMsg || type == QtFatalMsg) std::cerr << text.toStdString() << "\n";
}

}  // namespace

FigureApplication::FigureApplication() {
  if (QCoreApplication::instance()) return;
  setArguments();
  const QtMessageHandler before = qInstallMessageHandler(swallow);
  own_ = std::make_unique<QGuiApplication>(argumentCount, arguments);
  qInstallMessageHandler(before);
  std::setlocale(LC_NUMERIC, "C");  // Qt has set the user's, in which decimals may have a comma
}

FigureApplication::~FigureApplication() = default;

}  // namespace mien
