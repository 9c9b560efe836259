// Draws Mien Studio's window into a PNG file, for the documentation and for looking at it:
// studio_picture OUT.png WIDTHxHEIGHT [SETTING...]
// Settings: dark, side, fortyfive, mesh=2, color=Patches, unlinked, expression=joy, viseme=A, play, tab=4, fap=53:200,
// a=2, file=X.fap, frame=100, range=50:120, dock=plotDock, compare=X.ply, press=fapAll, scan=X.ply, scale=0.75,
// workspace=2, tour=3, focus=spectrumFigure, trigger=actionManual, grab=manualWindow, menu=editMenu, wait=2000,
// measure, export=spectrumExport:X.pdf (or face, curves), start, act (what follows is a step of undo).

#include <unistd.h>

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QFile>
#include <QImage>
#include <QKeyEvent>
#include <QMenu>
#include <QMenuBar>
#include <QMouseEvent>
#include <QPainter>
#include <QSurfaceFormat>
#include <QTabBar>
#include <QTableWidget>
#include <QTextStream>
#include <QTimer>
#include <QToolButton>
#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <vector>

#include "AnimationPlayer.h"
#include "Comparison.h"
#include "ExportButton.h"
#include "Exporter.h"
#include "FaceModel.h"
#include "ScanPanel.h"
#include "StudioWindow.h"
#include "Theme.h"
#include "Tour.h"
#include "ViewArea.h"

namespace {

void wait(int milliseconds) {
  QElapsedTimer clock;
  clock.start();
  while (clock.elapsed() < milliseconds) QApplication::processEvents(QEventLoop::AllEvents, 20);
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

/// How long the pipeline, and the pipeline with all views, take for each of 200 steps.
void measureSteps(mien::StudioWindow& window, const char* what, const std::function<void(int)>& take) {
  std::vector<double> pipeline, whole;
  for (int step = 1; step <= 200; ++step) {
    QElapsedTimer clock;
    clock.start();
    take(step);
    for (int i = 0; i < 3; ++i) QApplication::processEvents();
    whole.push_back(clock.nsecsElapsed() * 1e-6);
    pipeline.push_back(window.model().pipelineTime());
  }
  QTextStream(stdout) << what << ": pipeline " << median(pipeline) << " ms, with all views " << median(whole)
                      << " ms (medians of 200)\n";
}

/// Drags a slider, then scrubs through the demonstration.
void measure(mien::StudioWindow& window) {
  mien::FaceModel& model = window.model();
  measureSteps(window, "a step of a slider",
               [&](int step) { model.change([&](mien::FaceState& state) { state.fapValues[33] = step; }); });
  window.playDemonstration();
  window.player().pause();
  measureSteps(window, "a frame scrubbed to",
               [&](int step) { model.showFrame(17 * step % std::max(1, model.frameCount())); });
}

/// From the start of the process, with all its threads, to the first picture of the face.
class StartClock : public QObject {
 public:
  explicit StartClock(QWidget* view) : QObject(view) { view->installEventFilter(this); }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Paint && !told_) QTimer::singleShot(0, this, [this] { tell(); });
    return QObject::eventFilter(watched, event);
  }

 private:
  void tell() {
    if (told_) return;
    told_ = true;
    timespec processor{}, now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &processor);
    clock_gettime(CLOCK_BOOTTIME, &now);
    QFile stat("/proc/self/stat");
    stat.open(QIODevice::ReadOnly);
    const QString fields = QString::fromLatin1(stat.readAll());
    const double started = fields.section(") ", 1).section(' ', 19, 19).toDouble() / sysconf(_SC_CLK_TCK);
    QTextStream(stdout) << "first picture after " << now.tv_sec + 1e-9 * now.tv_nsec - started << " s, with "
                        << processor.tv_sec + 1e-9 * processor.tv_nsec << " s of processor time\n";
  }
  bool told_ = false;
};

/// Seven bits a channel, which nobody sees and which make the file smaller; of six, the last step of a background reads
/// as a seam.
QImage coarse(QImage picture) {
  for (int y = 0; y < picture.height(); ++y)
    for (int i = 0; i < 3 * picture.width(); ++i) {
      uchar& channel = picture.scanLine(y)[i];
      channel = static_cast<uchar>(channel & 0xfe) | (channel >> 7);
    }
  return picture;
}

/// The part of the window of that name; without one the program ends, and names those there are.
template <class Part>
Part* part(QObject& window, const QString& name) {
  auto* found = window.findChild<Part*>(name);
  if (found) return found;
  QStringList names;
  for (const Part* one : window.findChildren<Part*>())
    if (!one->objectName().isEmpty() && !one->objectName().startsWith("qt_")) names << one->objectName();
  names.removeDuplicates();
  names.sort();
  QTextStream(stderr) << "studio_picture: there is no " << QString(Part::staticMetaObject.className()).mid(1) << " '"
                      << name << "' in the window; there are " << names.join(", ") << "\n";
  std::exit(2);
}

void click(QWidget& window, const char* name) {
  part<QToolButton>(window, name)->click();
}

void showDock(QWidget& window, const QString& name) {
  part<QDockWidget>(window, name)->toggleViewAction()->trigger();
  const auto isBusy = [&] { return window.findChild<QWidget*>("smoothingProgress")->isVisible(); };
  do wait(1500);  // some docks compute in the background
  while (isBusy());
}

void press(QWidget& window, const QString& name) {
  part<QAbstractButton>(window, name)->click();
  wait(1500);
}

void openScan(QWidget& window, const QString& fileName) {
  auto* panel = window.findChild<mien::ScanPanel*>("scanPanel");
  panel->openDropped(fileName);
  while (panel->isMeasuring()) wait(200);
}

void chooseRow(QWidget& window, int row) {
  window.findChild<QTableWidget*>("continuityTable")->selectRow(row);
  wait(1500);  // the camera flies there
}

/// A coefficient by region and column, from 1: "12:4".
void clickCell(QWidget& window, const QString& cell) {
  auto* table = window.findChild<QTableWidget*>("deformationCoefficients");
  const int row = cell.section(':', 0, 0).toInt() - 1, column = cell.section(':', 1).toInt() - 1;
  table->setCurrentCell(row, column);
  emit table->cellClicked(row, column);
  wait(500);
}

/// What follows is the user's own step.
void act(mien::StudioWindow& window) {
  for (QEvent::Type type : {QEvent::MouseButtonPress, QEvent::MouseButtonRelease}) {
    QMouseEvent event(type, {}, Qt::LeftButton, Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &event);
  }
}

/// As far as that stop, from 1.
void showTour(mien::StudioWindow& window, int stop) {
  mien::Tour* tour = mien::Tour::begin(window);
  for (int i = 1; i < stop; ++i) {
    QKeyEvent space(QEvent::KeyPress, Qt::Key_Space, Qt::NoModifier);
    QApplication::sendEvent(tour, &space);
  }
}

void openMenu(mien::StudioWindow& window, const QString& name) {
  auto* menu = part<QMenu>(window, name);
  const QRect place = window.menuBar()->actionGeometry(menu->menuAction());
  menu->popup(window.menuBar()->mapToGlobal(place.bottomLeft()));
  wait(200);
}

/// The window with what has popped up over it.
QImage pictureOf(mien::StudioWindow& window) {
  QPixmap picture = window.grab();
  QPainter painter(&picture);
  if (QWidget* popup = QApplication::activePopupWidget())
    painter.drawPixmap(window.mapFromGlobal(popup->pos()), popup->grab());
  return picture.toImage().convertToFormat(QImage::Format_RGB888);
}

/// The entry of a list, or a mesh file.
void compare(QWidget& window, const QString& with) {
  auto* area = window.findChild<mien::ViewArea*>("viewArea");
  auto* choice = window.findChild<QComboBox*>("compareWith");
  const int index = choice->findText(with);
  index < 0 ? void(area->comparison()->openMesh(with)) : emit choice->activated(index);
  wait(1500);
}

/// What a button, or "face" or "curves", exports, into BUTTON:FILE, in the format of its ending.
void exportFigure(QWidget& window, const QString& what) {
  const QString name = what.section(':', 0, 0), file = what.section(':', 1);
  auto* area = window.findChild<mien::ViewArea*>("viewArea");
  if (name == "face") return void(area->faceExporter()->write(file));
  if (name == "curves") return void(area->curveExporter()->write(file));
  static_cast<mien::ExportButton*>(part<QToolButton>(window, name))->write(file);
}

/// A setting that nobody knows ends the program before it shows anything.
void checkSettings(const QStringList& settings) {
  const QStringList known = {"a",     "act",     "cell",       "choose", "color", "compare",  "dark",
                             "dock",  "export",  "expression", "fap",    "file",  "focus",    "fortyfive",
                             "frame", "grab",    "measure",    "menu",   "mesh",  "play",     "press",
                             "range", "row",     "scale",      "scan",   "side",  "start",    "tab",
                             "tour",  "trigger", "unlinked",   "viseme", "wait",  "workspace"};
  for (const QString& setting : settings) {
    if (known.contains(setting.section('=', 0, 0))) continue;
    QTextStream(stderr) << "studio_picture: there is no setting '" << setting << "'; there are " << known.join(", ")
                        << "\n";
    std::exit(2);
  }
}

void apply(mien::StudioWindow& window, const QString& setting) {
  const QString key = setting.section('=', 0, 0), value = setting.section('=', 1);
  mien::FaceModel& model = window.model();
  if (key == "dark") window.findChild<QAction*>("actionDark")->trigger();
  if (key == "side") click(window, "lookSide");
  if (key == "fortyfive") click(window, "lookFortyFive");
  if (key == "mesh") window.findChild<QComboBox*>("faceMesh")->setCurrentIndex(value.toInt());
  if (key == "color") window.findChild<QComboBox*>("colorBy")->setCurrentText(value);
  if (key == "unlinked") click(window, "curveLink");
  if (key == "tab") window.findChild<QTabBar*>("fapTabs")->setCurrentIndex(value.toInt());
  if (key == "expression") model.change([&](mien::FaceState& state) { state.expressions[value.toStdString()] = 1.0; });
  if (key == "viseme") model.change([&](mien::FaceState& state) { state.visemes[value.toStdString()] = 1.0; });
  if (key == "play") window.player().play();
  if (key == "fap")
    model.change([&](mien::FaceState& state) {
      state.fapValues[value.section(':', 0, 0).toInt()] = value.section(':', 1).toDouble();
    });
  if (key == "a") model.change([&](mien::FaceState& state) { state.surface.smoothing.fill(value.toDouble()); });
  if (key == "dock") showDock(window, value);
  if (key == "press") press(window, value);
  if (key == "scan") openScan(window, value);
  if (key == "row") chooseRow(window, value.toInt());
  if (key == "cell") clickCell(window, value);
  if (key == "compare") compare(window, value);
  if (key == "choose")
    part<QComboBox>(window, value.section(':', 0, 0))->setCurrentIndex(value.section(':', 1).toInt());
  if (key == "workspace") window.findChild<QTabBar*>("workspaces")->setCurrentIndex(value.toInt() - 1);
  if (key == "tour") showTour(window, value.toInt());
  if (key == "focus") part<QWidget>(window, value)->setFocus();
  if (key == "trigger") part<QAction>(window, value)->trigger();
  if (key == "menu") openMenu(window, value);
  if (key == "act") act(window);
  if (key == "measure") measure(window);
  if (key == "wait") wait(value.toInt());
  if (key == "file") window.openFile(value);
  if (key == "frame") model.showFrame(value.toDouble());
  if (key == "export") exportFigure(window, value);
  if (key == "range") window.player().setRange(value.section(':', 0, 0).toInt(), value.section(':', 1).toInt());
}

}  // namespace

int main(int argc, char** argv) {
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QApplication application(argc, argv);
  const QStringList arguments = QApplication::arguments();
  if (arguments.size() < 3) {
    QTextStream(stderr) << "usage: studio_picture OUT.png WIDTHxHEIGHT [SETTING...]\n";
    return 2;
  }
  checkSettings(arguments.mid(3));
  mien::Theme::apply(mien::Theme::Kind::Light, application);
  mien::StudioWindow window;
  window.resize(arguments[2].section('x', 0, 0).toInt(), arguments[2].section('x', 1).toInt());
  if (arguments.contains("start")) new StartClock(window.findChild<QWidget*>("faceView"));
  window.show();
  wait(500);
  double share = 1.0;
  QString grabbed;
  for (const QString& setting : arguments.mid(3)) {
    apply(window, setting);
    if (setting.startsWith("grab=")) grabbed = setting.section('=', 1);
    if (setting.startsWith("scale=")) share = setting.section('=', 1).toDouble();
  }
  wait(500);
  QWidget* shown = grabbed.isEmpty() ? nullptr : part<QWidget>(window, grabbed);
  const QImage picture = shown ? shown->grab().toImage().convertToFormat(QImage::Format_RGB888) : pictureOf(window);
  const int width = static_cast<int>(share * picture.width());
  constexpr int smallestFile = 0;  // as PNG files have no quality to lose
  const QImage scaled = coarse(picture.scaledToWidth(width, Qt::SmoothTransformation));
  return scaled.save(arguments[1], "PNG", smallestFile) ? 0 : 1;
}
