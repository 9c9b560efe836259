#include <QVTKOpenGLNativeWidget.h>

#include <QApplication>
#include <QCommandLineParser>
#include <QLocale>
#include <QSurfaceFormat>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "AnimationPlayer.h"
#include "MessageBar.h"
#include "StudioWindow.h"
#include "Theme.h"
#include "Tour.h"
#include "WindowPicture.h"

namespace {

constexpr int wrongValue = 2;  // exit code, as of mien

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

struct Options {
  QCommandLineOption play = {"play", "Play the file at once; without a file, the demonstration."};
  QCommandLineOption table = {
      "fat", "Your own animation table, which says what each FAP moves (`mien fat check` tells what is wrong with it).",
      "FILE.json"};
  QCommandLineOption state = {"state", "Shows the face of this session, or of the state that figures carry.",
                              "FILE.json"};
  QCommandLineOption picture = {
      "picture", "Writes a picture of the window and ends; needs a display, be it one of Xvfb.", "FILE.png"};
};

/// Reads the arguments, and ends the program after help or version.
void read(QCommandLineParser& arguments, const Options& options, const QCoreApplication& application) {
  arguments.setApplicationDescription("Shows and animates a PDE face.");
  arguments.addPositionalArgument(
      "FILE",
      "What to open, one after the other: animations .fap .csv, sessions .json, tables .csv .json, curves .vtp .mienz, "
      "scans .ply .obj "
      ".stl .off, photographs .png .jpg .tif with their mesh or landmarks .csv; - plays a .fap stream from standard "
      "input.",
      "[FILE..]");
  arguments.addOptions({options.play, options.table, options.state, options.picture});
  arguments.addHelpOption();
  arguments.addVersionOption();
  arguments.process(application);
}

int say(const QString& fault, int exitCode) {
  std::fprintf(stderr, "mien-studio: %s\n", qPrintable(fault));
  return exitCode;
}

/// @return whether all that was asked for is open; else the window's message says why not
bool openFiles(mien::StudioWindow& window, const QCommandLineParser& arguments, const Options& options) {
  const QStringList files = arguments.positionalArguments();
  if (arguments.isSet(options.table) && !window.openAnimationTable(arguments.value(options.table))) return false;
  if (!files.isEmpty() && files.first() == "-") {
    window.playStream(0);
  } else if (!files.isEmpty()) {
    for (const QString& file : files)
      if (!window.openFile(file)) return false;
    if (arguments.isSet(options.play)) window.player().play();
  } else if (arguments.isSet(options.play)) {
    window.playDemonstration();
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  name();
  QCommandLineParser arguments;
  const Options options;
  if (asksForText(argc, argv)) read(arguments, options, QCoreApplication(argc, argv));
  QSurfaceFormat::setDefaultFormat(
      QVTKOpenGLNativeWidget::defaultFormat());  // before the application, or views stay black
  QApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
#endif
  const QtMessageHandler usual = qInstallMessageHandler(sayWithoutDisplay);
  QLocale::setDefault(QLocale::c());  // numbers of fields as those of labels, figures, files and commands beside them
  QApplication application(argc, argv);
  qInstallMessageHandler(usual);
  read(arguments, options, application);
  if (arguments.isSet(options.picture)) {
    const QString fault = mien::WindowPicture::describeEnding(arguments.value(options.picture));
    if (!fault.isEmpty()) return say(fault, wrongValue);
  }

  mien::Theme::apply(mien::Theme::preferred(application), application);
  mien::StudioWindow window;
  window.show();
  const bool isPlain = !arguments.isSet(options.picture) && arguments.positionalArguments().isEmpty();
  if (isPlain) mien::Tour::showAtFirstStart(window);
  if (arguments.isSet(options.state)) {
    const QString fault = mien::WindowPicture::show(window, arguments.value(options.state));
    if (!fault.isEmpty()) return say(fault, EXIT_FAILURE);
  }
  std::unique_ptr<mien::WindowPicture> picture;
  if (arguments.isSet(options.picture))
    picture = std::make_unique<mien::WindowPicture>(window, arguments.value(options.picture));
  if (!openFiles(window, arguments, options) && picture)
    return say(window.findChild<mien::MessageBar*>()->sentence(), EXIT_FAILURE);
  return QApplication::exec();
}
