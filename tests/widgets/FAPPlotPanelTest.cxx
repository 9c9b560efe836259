#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QTemporaryDir>
#include <QToolButton>
#include <QWheelEvent>
#include <cmath>

#include "AnimationPlayer.h"
#include "ExportButton.h"
#include "FAPPlotPanel.h"
#include "FAPText.h"
#include "FaceModel.h"
#include "FigureView.h"
#include "StudioFixture.h"
#include "ValueSlider.h"

namespace {

class FAPPlotPanel : public StudioFixture {
 protected:
  FAPPlotPanel() {
    EXPECT_TRUE(window->openAnimation(writeLids(101, 25)));
    QTest::mouseClick(find<QToolButton>("timelinePlot"), Qt::LeftButton);
    settle();
    figure = find<mien::FigureView>("plotFigure");
    panel = find<mien::FAPPlotPanel>("fapPlotPanel");
  }

  QPoint at(double time) const { return figure->pixelOf(0, time, 0.0).toPoint(); }

  mien::FigureView* figure;
  mien::FAPPlotPanel* panel;
};

TEST_F(FAPPlotPanel, PlotsWhatMovesInUnitsOverSeconds) {
  auto* list = find<QListWidget>("plotFAPs");
  ASSERT_EQ(list->count(), 1);
  EXPECT_TRUE(list->item(0)->text().startsWith("19 "));
  EXPECT_TRUE(list->item(0)->isSelected());
  const mien::ChartSeries& series = figure->figure().panels.at(0).series.at(0);
  ASSERT_EQ(series.x.size(), 101u);
  EXPECT_EQ(series.x[50], 2.0);
  EXPECT_EQ(series.y[50], 1000.0);
}

TEST_F(FAPPlotPanel, WhatIsPlottedStandsFirstInTheList) {
  window->playDemonstration();
  window->player().pause();
  settle();
  auto* list = find<QListWidget>("plotFAPs");
  const int plotted = list->selectedItems().size();
  ASSERT_GT(plotted, 1);
  ASSERT_GT(list->count(), plotted);
  for (int i = 0; i < list->count(); ++i) EXPECT_EQ(list->item(i)->isSelected(), i < plotted) << i;
}

TEST_F(FAPPlotPanel, MarksWhatHasNoSurface) {
  QFile file(QDir::temp().filePath(QString("mien_eyes_%1.fap").arg(QCoreApplication::applicationPid())));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("2.1 eyes 25 2\n");
  for (int frame = 0; frame < 2; ++frame)
    file.write(QString::fromStdString(maskText({19, 23}) + "\n").toUtf8() +
               QString("%1 %2 %3\n").arg(frame).arg(100 * frame).arg(900 * frame).toUtf8());
  file.close();
  ASSERT_TRUE(window->openAnimation(file.fileName()));
  auto* list = find<QListWidget>("plotFAPs");
  ASSERT_EQ(list->count(), 2);
  EXPECT_FALSE(list->item(0)->text().contains("no surface"));
  EXPECT_TRUE(list->item(1)->text().endsWith("(no surface)")) << list->item(1)->text().toStdString();
  EXPECT_TRUE(list->item(0)->isSelected());
  EXPECT_FALSE(list->item(1)->isSelected());
  EXPECT_TRUE(find<QLabel>("plotHint")->text().startsWith("2 FAPs change, 1 of them without effect"))
      << find<QLabel>("plotHint")->text().toStdString();
  file.remove();
}

TEST_F(FAPPlotPanel, FollowsAStreamThatGrows) {
  std::vector<mien::FAPFrame> frames(3);
  for (int i = 0; i < 3; ++i) frames[i].setValue(33, 10.0 * i);
  window->model().appendLive(25.0, "live", frames);
  window->model().appendLive(25.0, "live", frames);
  ASSERT_TRUE(waitUntil(
      [this] { return !figure->figure().panels.empty() && figure->figure().panels[0].series[0].x.size() == 6; }));
  EXPECT_EQ(panel->shownEnd(), 5.0 / 25.0);
}

TEST_F(FAPPlotPanel, AClickInTheListTakesAFAPAwayAndBrings) {
  auto* list = find<QListWidget>("plotFAPs");
  const QPoint item = list->visualItemRect(list->item(0)).center();
  QTest::mouseClick(list->viewport(), Qt::LeftButton, Qt::NoModifier, item);
  EXPECT_TRUE(figure->figure().panels.empty());
  QTest::mouseClick(list->viewport(), Qt::LeftButton, Qt::NoModifier, item);
  EXPECT_EQ(figure->figure().panels.at(0).series.size(), 1u);
}

TEST_F(FAPPlotPanel, ClickAndDragScrub) {
  QTest::mousePress(figure, Qt::LeftButton, Qt::NoModifier, at(1.0));
  EXPECT_NEAR(window->model().frameIndex(), 25, 1);
  const double near = largestDisplacement();
  dragTo(figure, at(3.0));
  QTest::mouseRelease(figure, Qt::LeftButton, Qt::NoModifier, at(3.0));
  EXPECT_NEAR(window->model().frameIndex(), 75, 1);
  EXPECT_GT(largestDisplacement(), 1.1 * near);
  EXPECT_NEAR(*figure->marked(), 3.0, 0.05);
  QTest::keyClick(figure, Qt::Key_Home);
  EXPECT_EQ(window->model().frameIndex(), 0);
  QTest::keyClick(figure, Qt::Key_Right);
  EXPECT_EQ(window->model().frameIndex(), 1);
}

TEST_F(FAPPlotPanel, TheLineFollowsTheAnimation) {
  window->model().showFrame(50);
  EXPECT_NEAR(*figure->marked(), 2.0, 1e-9);
}

TEST_F(FAPPlotPanel, TheWheelZoomsAroundThePointerAndAButtonBack) {
  const QPoint place = at(3.0);
  QWheelEvent wheel(place, QPointF(figure->mapToGlobal(place)), {}, {0, 360}, Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(figure, &wheel);
  EXPECT_NEAR(panel->shownEnd() - panel->shownBegin(), 4.0 / std::pow(1.25, 3), 1e-9);
  EXPECT_NEAR(at(3.0).x(), place.x(), 2) << "what is under the pointer stays there";
  EXPECT_EQ(figure->figure().panels[0].x.begin, panel->shownBegin());
  for (int i = 0; i < 30; ++i) find<QToolButton>("plotZoomIn")->click();
  EXPECT_NEAR(panel->shownEnd() - panel->shownBegin(), 4.0 / 25.0, 1e-9) << "four frames at least";
  find<QToolButton>("plotWhole")->click();
  EXPECT_EQ(panel->shownBegin(), 0.0);
  EXPECT_EQ(panel->shownEnd(), 4.0);
}

TEST_F(FAPPlotPanel, DraggingWithShiftSetsTheRangeThatIsPlayed) {
  QTest::mousePress(figure, Qt::LeftButton, Qt::ShiftModifier, at(3.0));
  dragTo(figure, at(1.0));
  QTest::mouseRelease(figure, Qt::LeftButton, Qt::ShiftModifier, at(1.0));
  EXPECT_NEAR(window->player().rangeBegin(), 25, 1);
  EXPECT_NEAR(window->player().rangeEnd(), 75, 1);
  EXPECT_EQ(window->model().frameIndex(), 0);
  ASSERT_TRUE(figure->band().has_value());
  EXPECT_TRUE(find<QToolButton>("timelineIn")->isChecked());
  find<QToolButton>("plotRange")->click();
  EXPECT_NEAR(panel->shownBegin(), 1.0, 0.05);
  EXPECT_NEAR(panel->shownEnd(), 3.0, 0.05);
}

TEST_F(FAPPlotPanel, WritesItsFigureAndNumbers) {
  QTemporaryDir folder;
  auto* button = find<mien::ExportButton>("plotExport");
  EXPECT_TRUE(button->write(folder.filePath("plot.pdf")));
  EXPECT_GT(QFile(folder.filePath("plot.pdf")).size(), 2000);
  EXPECT_TRUE(button->write(folder.filePath("plot.csv")));
  QFile csv(folder.filePath("plot.csv"));
  ASSERT_TRUE(csv.open(QIODevice::ReadOnly));
  const QList<QByteArray> lines = csv.readAll().trimmed().split('\n');
  ASSERT_EQ(lines.size(), 102);
  EXPECT_EQ(lines[0], "frame,time_s,fap19_close_t_l_eyelid");
  EXPECT_EQ(lines[51], "50,2,1000");
}

TEST_F(FAPPlotPanel, SaysWhatToDoWithoutAnAnimation) {
  window->model().closeAnimation();
  EXPECT_EQ(find<QListWidget>("plotFAPs")->count(), 0);
  EXPECT_TRUE(figure->figure().panels.empty());
  EXPECT_FALSE(figure->marked().has_value());
}

using Playback = StudioFixture;

TEST_F(Playback, LoopsInItsRange) {
  ASSERT_TRUE(window->openAnimation(writeLids(60, 50)));
  auto* in = find<QToolButton>("timelineIn");
  auto* out = find<QToolButton>("timelineOut");
  window->model().showFrame(20);
  QTest::mouseClick(in, Qt::LeftButton);
  window->model().showFrame(30);
  QTest::mouseClick(out, Qt::LeftButton);
  EXPECT_EQ(window->player().rangeBegin(), 20);
  EXPECT_EQ(window->player().rangeEnd(), 30);
  int least = 1000, most = 0, wraps = 0, last = 0;
  window->player().play();
  QObject::connect(&window->model(), &mien::FaceModel::stateChanged, [&] {
    const int frame = window->model().frameIndex();
    least = std::min(least, frame);
    most = std::max(most, frame);
    wraps += frame < last;
    last = frame;
  });
  EXPECT_TRUE(waitUntil([&] { return wraps >= 2; }, 20000));
  window->player().pause();
  EXPECT_GE(least, 20);
  EXPECT_LE(most, 30);
  QTest::mouseClick(in, Qt::LeftButton);
  EXPECT_EQ(window->player().rangeBegin(), 0);
  ASSERT_TRUE(window->openAnimation(writeLids(11, 5)));
  EXPECT_FALSE(window->player().hasRange()) << "another file, another range";
}

TEST_F(Playback, SpeedChangesHowLongItTakes) {
  ASSERT_TRUE(window->openAnimation(writeLids(11, 20)));
  find<QToolButton>("timelineLoop")->setChecked(false);
  auto* speed = find<QComboBox>("timelineSpeed");
  speed->setCurrentIndex(speed->findData(0.5));
  QElapsedTimer clock;
  clock.start();
  window->player().play();
  ASSERT_TRUE(waitUntil([this] { return !window->player().isPlaying(); }, 20000));
  EXPECT_GE(clock.elapsed(), 1000) << "eleven frames of 50 ms at half the speed take no less";
}

TEST_F(Playback, InterpolationShowsTheMixtureOfTwoFrames) {
  ASSERT_TRUE(window->openAnimation(writeLids(11, 5)));
  auto* between = find<QToolButton>("timelineSmooth");
  window->model().showFrame(4.25);
  EXPECT_EQ(window->model().shownFAP(19), 80.0) << "frame 4 alone";
  QTest::mouseClick(between, Qt::LeftButton);
  window->model().showFrame(4.25);
  EXPECT_NEAR(window->model().shownFAP(19), 85.0, 1e-9);
  EXPECT_EQ(window->model().frameIndex(), 4);
  settle();
  EXPECT_NEAR(find<mien::ValueSlider>("fapSlider19")->shownValue(), 85.0, 1e-9);
  const double mixed = largestDisplacement();
  QTest::mouseClick(between, Qt::LeftButton);
  EXPECT_LT(largestDisplacement(), mixed);
  EXPECT_EQ(window->model().framePosition(), 4.0);
}

TEST_F(Playback, TheRateShownIsMeasuredWhilePlaying) {
  ASSERT_TRUE(window->openAnimation(writeLids(100, 20)));
  auto* rate = find<QLabel>("timelineRate");
  EXPECT_EQ(rate->text(), "");
  window->player().play();
  EXPECT_TRUE(waitUntil([&] { return rate->text().endsWith(" frames/s drawn"); }, 20000));
  window->player().pause();
  EXPECT_EQ(rate->text(), "");
}

}  // namespace
