#include "StudioWindow.h"

#include "AnimationPlayer.h"
#include "Theme.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QSurfaceFormat>
#include <QVTKOpenGLNativeWidget.h>

int main(int argc, char** argv) {
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());  // before the application, or views stay black
  QApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
#endif
  QApplication application(argc, argv);
  QApplication::setOrganizationName("mien");
  QApplication::setApplicationName("mien-studio");
  QApplication::setApplicationDisplayName("Mien Studio");
  QApplication::setApplicationVersion(MIEN_VERSION);

  QCommandLineParser arguments;
  arguments.setApplicationDescription("Shows and animates a PDE face.");
  arguments.addPositionalArgument("FILE.fap", "A facial animation to open, .fap or .csv; - plays a .fap stream from standard input.", "[FILE.fap]");
  const QCommandLineOption play("play", "Play the file at once; without a file, the demonstration.");
  arguments.addOption(play);
  arguments.addHelpOption();
  arguments.addVersionOption();
  arguments.process(application);

  mien::Theme::apply(mien::Theme::Kind::Light, application);
  mien::StudioWindow window;
  window.show();
  const QStringList files = arguments.positionalArguments();
  if (!files.isEmpty() && files.first() == "-") {
    window.playStream(0);
  } else if (!files.isEmpty()) {
    if (window.openAnimation(files.first()) && arguments.isSet(play)) window.player().play();
  } else if (arguments.isSet(play)) {
    window.playDemonstration();
  }
  return QApplication::exec();
}
