#include "StudioFixture.h"

#include <vtkAlgorithm.h>
#include <vtkDataArray.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QMouseEvent>
#include <QTextStream>

#include "FaceModel.h"
#include "MessageBar.h"

namespace {

/// Counts what VTK says.
class CountingWindow : public vtkOutputWindow {
 public:
  static CountingWindow* New();
  vtkTypeMacro(CountingWindow, vtkOutputWindow);
  void DisplayText(const char* text) override { texts += text; }
  std::string texts;
};
vtkStandardNewMacro(CountingWindow);

CountingWindow* vtkMessages() {
  static CountingWindow* messages = [] {
    auto* created = CountingWindow::New();
    vtkOutputWindow::SetInstance(created);
    return created;
  }();
  return messages;
}

void setDrawn(mien::StudioWindow& window, bool drawn) {
  for (const char* view : {"faceView", "curveView"}) window.findChild<QWidget*>(view)->setUpdatesEnabled(drawn);
}

}  // namespace

StudioFixture::StudioFixture() {
  vtkMessages()->texts.clear();
  window = std::make_unique<mien::StudioWindow>();
  setDrawn(*window, false);
  window->show();
  EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
  settle();
}

StudioFixture::~StudioFixture() = default;

void StudioFixture::TearDown() {
  window.reset();
  QApplication::processEvents();
  EXPECT_EQ(vtkMessages()->texts, "");
}

void StudioFixture::drawViews() {
  setDrawn(*window, true);
  settle();
}

void StudioFixture::settle() {
  for (int i = 0; i < 3; ++i) QApplication::processEvents(QEventLoop::AllEvents);
}

bool StudioFixture::waitUntil(const std::function<bool()>& condition, int milliseconds) {
  return QTest::qWaitFor(condition, milliseconds);
}

double StudioFixture::largestDisplacement() {
  settle();
  return largestMovement();
}

double StudioFixture::largestMovement() {
  auto* curves = vtkPolyData::SafeDownCast(window->model().pipeline().curves()->GetOutputDataObject(0));
  return curves->GetPointData()->GetArray("Displacement")->GetMaxNorm();
}

vtkPolyData* StudioFixture::surface() {
  settle();
  return vtkPolyData::SafeDownCast(window->model().pipeline().surface()->GetOutputDataObject(0));
}

void StudioFixture::dragTo(QWidget* widget, const QPoint& position) {
  QMouseEvent move(QEvent::MouseMove, QPointF(position), QPointF(widget->mapToGlobal(position)), Qt::NoButton,
                   Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(widget, &move);
}

void StudioFixture::drag(QWidget* widget, const QPoint& from, const QPoint& by) {
  QTest::mousePress(widget, Qt::LeftButton, Qt::NoModifier, from);
  for (int i = 1; i <= 4; ++i) dragTo(widget, from + by * i / 4);
  QTest::mouseRelease(widget, Qt::LeftButton, Qt::NoModifier, from + by);
}

int StudioFixture::colorsIn(const QString& viewName) {
  settle();
  const QImage image = find<QWidget>(viewName)->grab().toImage();
  std::set<QRgb> colors;
  for (int y = 0; y < image.height(); y += 2)
    for (int x = 0; x < image.width(); x += 2) colors.insert(image.pixel(x, y));
  return static_cast<int>(colors.size());
}

QString StudioFixture::message() {
  auto* bar = find<mien::MessageBar>("messageBar");
  return bar->isVisible() ? bar->sentence() : QString();
}

QString StudioFixture::writeLids(int frames, double framesPerSecond) {
  const QString name = QDir::temp().filePath(QString("mien_lids_%1.fap").arg(QCoreApplication::applicationPid()));
  QFile file(name);
  file.open(QIODevice::WriteOnly);
  QTextStream text(&file);
  text << "2.1 lids " << framesPerSecond << " " << frames << "\n";
  for (int i = 0; i < frames; ++i) {
    for (int fap = 1; fap <= 68; ++fap) text << (fap == 19 ? "1 " : "0 ");
    text << "\n" << i << " " << 20 * i << "\n";
  }
  return name;
}
