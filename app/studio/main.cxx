#include <QVTKOpenGLNativeWidget.h>

#include <QApplication>
#include <QCommandLineParser>
#include <QSurfaceFormat>
#include <cstdio>
#include <cstdlib>

#include "AnimationPlayer.h"
#include "StudioWindow.h"
#include "Theme.h"

namespace {

/// While the application begins, Qt ends the program without a display after lines about its plugins.
void sayWithoutDisplay(QtMsgType type, const QMessageLogContext&, const QString&) {
  if (type != QtFatalMsg) return;
  std::fputs(
      "mien-studio: there is no display to open a window on; start it in a desktop session, set DISPLAY or "
      "WAYLAND_DISPLAY, or "
      "use `mien render` and `mien animate`, which need none\n",
      stderr);
  std::_Exit(EXIT_FAILURE);
}

bool asksForText(int argc, char** argv) {
  for (int i = 1; i < argc; ++i)
    for (const char* option : {"-h", "--help", "--help-all", "-v", "--version"})
      if (qstrcmp(argv[i], option) == 0) return true;
  return false;
}

void name() {
  QCoreApplication::setOrganizationName("mien");
  QCoreApplication::setApplicationName("mien-studio");
  QGuiApplication::setApplicationDisplayName("Mien Studio");
  QCoreApplication::setApplicationVersion(MIEN_VERSION);
}

/// Reads the arguments, and ends the program after help or version.
void read(QCommandLineParser& arguments, const QList<QCommandLineOption>& options,
          const QCoreApplication& application) {
  arguments.setApplicationDescription("Shows and animates a PDE face.");
  arguments.addPositionalArgument(
      "FILE.fap", "A facial animation to open, .fap or .csv; - plays a .fap stream from standard input.", "[FILE.fap]");
  arguments.addOptions(options);
  arguments.addHelpOption();
  arguments.addVersionOption();
  arguments.process(application);
}

}  // namespace

int main(int argc, char** argv) {
  name();
  QCommandLineParser arguments;
  const QCommandLineOption play("play", "Play the file at once; without a file, the demonstration.");
  const QCommandLineOption table(
      "fat", "Your own animation table, which says what each FAP moves (`mien fat check` tells what is wrong with it).",
      "FILE.json");
  if (asksForText(argc, argv)) read(arguments, {play, table}, QCoreApplication(argc, argv));
  QSurfaceFormat::setDefaultFormat(
      QVTKOpenGLNativeWidget::defaultFormat());  // before the application, or views stay black
  QApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
#endif
  const QtMessageHandler usual = qInstallMessageHandler(sayWithoutDisplay);
  QApplication application(argc, argv);
  qInstallMessageHandler(usual);
  read(arguments, {play, table}, application);

  mien::Theme::apply(mien::Theme::Kind::Light, application);
  mien::StudioWindow window;
  window.show();
  if (arguments.isSet(table)) window.openAnimationTable(arguments.value(table));
  const QStringList files = arguments.positionalArguments();
  if (!files.isEmpty() && files.first() == "-") {
    window.playStream(0);
  } else if (!files.isEmpty()) {
    if (window.openFile(files.first()) && arguments.isSet(play)) window.player().play();
  } else if (arguments.isSet(play)) {
    window.playDemonstration();
  }
  return QApplication::exec();
}
