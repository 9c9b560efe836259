#include <vtkPolyData.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QToolButton>
#include <atomic>
#include <map>

#include "BackgroundTask.h"
#include "ExportButton.h"
#include "FaceModel.h"
#include "FigureView.h"
#include "StudioFixture.h"

namespace {

class SmoothingPanel : public StudioFixture {
 protected:
  SmoothingPanel() {
    find<QAction>("smoothingDockAction")->trigger();
    figure = find<mien::FigureView>("smoothingFigure");
    EXPECT_TRUE(waitUntil([this] { return seriesCount() == 1; }, 20000));
  }

  size_t seriesCount() const { return figure->figure().panels.empty() ? 0 : figure->figure().panels[0].series.size(); }
  std::vector<double> values() const { return figure->figure().panels[0].series[0].y; }
  double a() const { return window->model().state().surface.smoothing.front(); }
  bool isRunning() { return find<QProgressBar>("smoothingProgress")->isVisible(); }

  void sweepOver(const QString& range) {
    auto* edit = find<QLineEdit>("smoothingRange");
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, range);
    QTest::keyClick(edit, Qt::Key_Return);
  }
  double depthSum() {
    double sum = 0.0;
    for (vtkIdType p = 0; p < surface()->GetNumberOfPoints(); ++p) sum += surface()->GetPoint(p)[2];
    return sum;
  }

  mien::FigureView* figure;
};

TEST_F(SmoothingPanel, DraggingTheLineSetsAAndTheFaceFollows) {
  const double before = depthSum();
  const QPoint start = figure->pixelOf(0, 1.0, values()[0]).toPoint(),
               end = figure->pixelOf(0, 4.0, values()[0]).toPoint();
  QTest::mousePress(figure, Qt::LeftButton, Qt::NoModifier, start);
  for (int i = 1; i <= 5; ++i) {
    dragTo(figure, start + i * (end - start) / 5);
    settle();
  }
  QTest::mouseRelease(figure, Qt::LeftButton, Qt::NoModifier, end);
  EXPECT_NEAR(a(), 4.0, 0.2);
  EXPECT_EQ(*figure->marked(), a());
  EXPECT_NE(depthSum(), before);
  EXPECT_GT(colorsIn("faceView"), 200);
  EXPECT_FALSE(isRunning());  // a sweep over a does not depend on a
}

TEST_F(SmoothingPanel, ArrowKeysChangeABySteps) {
  figure->setFocus();
  QTest::keyClick(figure, Qt::Key_Right);
  EXPECT_NEAR(a(), 1.1, 1e-9);
  QTest::keyClick(figure, Qt::Key_Home);
  EXPECT_NEAR(a(), 0.1, 1e-9);
}

/// Beyond the breakdown there is no face to see; an a that is set there all the same is on the axis.
TEST_F(SmoothingPanel, TheAxisEndsBehindTheBreakdownOrAtTheFaceShown) {
  const auto end = [this] { return figure->figure().panels[0].x.end.value_or(100.0); };
  const double breakdown = *figure->figure().panels[0].series[0].breakdown;
  EXPECT_DOUBLE_EQ(end(), 2.0 * breakdown);
  EXPECT_LT(end(), 20.0);
  const auto title = [this] { return QString::fromStdString(figure->figure().panels[0].x.title); };
  EXPECT_TRUE(title().startsWith("a (beyond ") && title().endsWith(" the surface is no face: off scale)"))
      << title().toStdString();
  figure->setFocus();
  QTest::keyClick(figure, Qt::Key_End);
  settle();
  EXPECT_NEAR(a(), 100.0, 1e-9);
  EXPECT_NEAR(end(), 100.0, 1e-9);
  EXPECT_EQ(title(), "a") << "all of the range is shown";
}

TEST_F(SmoothingPanel, TheRangeIsSaidInWords) {
  auto* said = find<QLabel>("smoothingSpacing");
  EXPECT_EQ(said->text(), "31 values, log spaced");
  for (const auto& [range, words] :
       std::map<QString, QString>{{"0.5:1:3", "3 values, evenly spaced"}, {"0.5,1", "2 values"}, {"2", "1 value"}}) {
    sweepOver(range);
    EXPECT_EQ(said->text(), words);
  }
}

TEST_F(SmoothingPanel, SmallFacesDifferAndSetA) {
  ASSERT_TRUE(waitUntil([this] { return find<QToolButton>("smoothingThumbnail4")->isEnabled(); }, 20000));
  std::vector<QImage> pictures;
  for (int i = 0; i < 5; ++i) {
    const QImage picture = find<QToolButton>(QString("smoothingThumbnail%1").arg(i))->icon().pixmap(84, 112).toImage();
    std::set<QRgb> colors;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) colors.insert(picture.pixel(x, y));
    EXPECT_GT(colors.size(), 100u) << i;
    for (const QImage& other : pictures) EXPECT_NE(picture, other) << i;
    pictures.push_back(picture);
  }
  QTest::mouseClick(find<QToolButton>("smoothingThumbnail0"), Qt::LeftButton);
  EXPECT_NEAR(a(), 0.1, 1e-9);
}

/// With room around it, and the edge of the crown as the round line that it is.
TEST_F(SmoothingPanel, SmallFacesAreWhole) {
  ASSERT_TRUE(waitUntil([this] { return find<QToolButton>("smoothingThumbnail4")->isEnabled(); }, 20000));
  for (int i = 0; i < 5; ++i) {
    const QImage picture = find<QToolButton>(QString("smoothingThumbnail%1").arg(i))->icon().pixmap(84, 112).toImage();
    QRect drawn;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x)
        if (qAlpha(picture.pixel(x, y)) > 128) drawn |= QRect(x, y, 1, 1);
    EXPECT_TRUE(picture.rect().adjusted(2, 2, -2, -2).contains(drawn)) << i;
    const auto topAt = [&](double share) {
      const int x = drawn.left() + static_cast<int>(share * (drawn.width() - 1));
      int y = drawn.top();
      while (qAlpha(picture.pixel(x, y)) <= 128) ++y;
      return y;
    };
    EXPECT_EQ(topAt(0.5), drawn.top()) << i;
    EXPECT_GE(topAt(0.25), drawn.top() + 1) << i;
    EXPECT_GE(topAt(0.75), drawn.top() + 1) << i;
  }
}

TEST_F(SmoothingPanel, AllSchemesAndEveryMeasureAreDrawn) {
  find<QCheckBox>("smoothingAllSchemes")->click();
  ASSERT_TRUE(waitUntil([this] { return seriesCount() == 6; }, 60000));
  auto* measure = find<QComboBox>("smoothingMeasure");
  EXPECT_EQ(measure->count(), 8);
  std::set<std::vector<double>> drawn;
  for (int i = 0; i < measure->count(); ++i) {
    measure->setCurrentIndex(i);
    EXPECT_EQ(mien::titleWithUnit(figure->figure().panels[0].y), measure->currentText().toStdString());
    drawn.insert(figure->figure().panels[0].series[0].y);
  }
  EXPECT_EQ(drawn.size(), 8u);
}

TEST_F(SmoothingPanel, TheRangeIsSweptAndAFaultIsSaid) {
  sweepOver("0.5,1,2");
  EXPECT_TRUE(waitUntil([this] { return values().size() == 3; }, 20000));
  sweepOver("0.5,nonsense");
  EXPECT_FALSE(message().isEmpty());
  EXPECT_EQ(values().size(), 3u);
}

TEST_F(SmoothingPanel, ACancelledSweepKeepsWhatWasShownAndCanStartAgain) {
  sweepOver("0.1:100:900log");
  ASSERT_TRUE(waitUntil([this] { return find<QProgressBar>("smoothingProgress")->value() > 0 && isRunning(); }, 20000));
  QTest::mouseClick(find<QToolButton>("smoothingCancel"), Qt::LeftButton);
  EXPECT_TRUE(waitUntil([this] { return !isRunning(); }));
  EXPECT_EQ(values().size(), 31u);
  sweepOver("0.5,1");
  EXPECT_TRUE(waitUntil([this] { return values().size() == 2; }, 20000));
}

TEST_F(SmoothingPanel, AWindowClosedMeanwhileDoesNoHarm) {
  sweepOver("0.1:100:900log");
  ASSERT_TRUE(waitUntil([this] { return isRunning(); }));
  window->close();
  window.reset();
  settle();
}

TEST_F(SmoothingPanel, ANewFaceIsSweptAnew) {
  const std::vector<double> before = values();
  window->model().change([](mien::FaceState& state) { state.fapValues[53] = 300; });
  EXPECT_TRUE(waitUntil([&] { return values() != before; }, 20000));
}

TEST_F(SmoothingPanel, WritesItsFigureAndNumbers) {
  auto* button = find<mien::ExportButton>("smoothingExport");
  const QString name = QDir::temp().filePath(QString("mien_smoothing_%1").arg(QCoreApplication::applicationPid()));
  for (const char* ending : {".svg", ".csv"}) EXPECT_TRUE(button->write(name + ending));
  QFile csv(name + ".csv");
  ASSERT_TRUE(csv.open(QIODevice::ReadOnly));
  EXPECT_EQ(csv.readAll().trimmed().split('\n').size(), 32);
  for (const char* ending : {".svg", ".csv"}) QFile::remove(name + ending);
}

TEST(BackgroundTask, WorkThatTakesTheOldWorksPlaceIsTheOneDelivered) {
  mien::BackgroundTask task(nullptr);
  std::vector<int> delivered;
  const auto work = [&](int number) {
    return [&delivered, number](const mien::BackgroundTask::Progress& goOn) -> std::function<void()> {
      for (int i = 0; i < 20 && goOn(i / 20.0); ++i) QTest::qSleep(2);
      return [&delivered, number] { delivered.push_back(number); };
    };
  };
  for (int number = 1; number <= 3; ++number) task.start(work(number));
  EXPECT_TRUE(QTest::qWaitFor([&] { return !task.isRunning(); }));
  EXPECT_EQ(delivered, std::vector<int>{3});
}

TEST(BackgroundTask, WorkThatWaitsLetsTheOldWorkFinish) {
  mien::BackgroundTask task(nullptr);
  std::vector<int> delivered;
  for (int number = 1; number <= 3; ++number)
    task.start(
        [&delivered, number](const mien::BackgroundTask::Progress&) {
          QTest::qSleep(20);
          return [&delivered, number] { delivered.push_back(number); };
        },
        mien::BackgroundTask::Before::Finishes);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !task.isRunning(); }));
  EXPECT_EQ(delivered, (std::vector<int>{1, 3}));
}

TEST(BackgroundTask, NothingIsDeliveredToAnOwnerThatIsGone) {
  std::atomic<bool> delivered{false}, begun{false};
  {
    mien::BackgroundTask task(nullptr);
    task.start([&](const mien::BackgroundTask::Progress& goOn) -> std::function<void()> {
      begun = true;
      while (goOn(0.5)) QTest::qSleep(1);
      return [&] { delivered = true; };
    });
    EXPECT_TRUE(QTest::qWaitFor([&] { return begun.load(); }));
  }
  QTest::qWait(20);
  EXPECT_FALSE(delivered);
}

}  // namespace
