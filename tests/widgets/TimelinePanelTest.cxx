#include <QDir>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QElapsedTimer>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QSpinBox>
#include <QToolButton>
#include <QUrl>
#include <algorithm>

#include "AnimationPlayer.h"
#include "FaceModel.h"
#include "StudioFixture.h"
#include "ValueSlider.h"

namespace {

using TimelinePanel = StudioFixture;
using mien::ValueSlider;

TEST_F(TimelinePanel, WaitsForAFile) {
  EXPECT_FALSE(find<QToolButton>("timelinePlay")->isEnabled());
  EXPECT_TRUE(find<QToolButton>("timelineOpen")->isEnabled());
  EXPECT_TRUE(find<QLabel>("timelineTitle")->text().contains(".fap"));
}

/// One slim line without an animation; with one as high whatever it does.
TEST_F(TimelinePanel, TakesRoomOnceThereIsAnAnimation) {
  auto* panel = find<QWidget>("timelinePanel");
  EXPECT_LE(panel->height(), 40);
  EXPECT_FALSE(find<QToolButton>("timelinePlay")->isVisible());
  QTest::mouseClick(find<QToolButton>("timelineDemonstration"), Qt::LeftButton);
  settle();
  EXPECT_GT(window->model().frameCount(), 0);
  EXPECT_TRUE(window->player().isPlaying());
  EXPECT_TRUE(find<QToolButton>("timelinePlay")->isVisible());
  const QRect open = panel->geometry();
  ASSERT_TRUE(waitUntil([this] { return window->model().frameIndex() > 3; }));
  EXPECT_EQ(panel->geometry(), open);
  window->player().pause();
  settle();
  EXPECT_EQ(panel->geometry(), open);
  QTest::mouseClick(find<QToolButton>("timelineClose"), Qt::LeftButton);
  settle();
  EXPECT_LE(panel->height(), 40);
}

TEST_F(TimelinePanel, AnOpenedFileIsShownAtItsFirstFrame) {
  ASSERT_TRUE(window->openAnimation(writeLids(11, 5)));
  EXPECT_EQ(find<ValueSlider>("timelinePosition")->maximum(), 10);
  EXPECT_EQ(find<QSpinBox>("timelineFrame")->value(), 1);
  EXPECT_EQ(find<QSpinBox>("timelineFrame")->text(), "0 / 10") << "as the file numbers them";
  EXPECT_EQ(find<QLabel>("timelineTime")->text(), QString(u8"0.00 s of 2.00 s \u00b7 5 frames/s"));
  EXPECT_EQ(largestDisplacement(), 0.0);
  EXPECT_EQ(message(), "");
}

TEST_F(TimelinePanel, ScrubbingShowsTheFrameUnderTheMouse) {
  ASSERT_TRUE(window->openAnimation(writeLids(11, 5)));
  auto* slider = find<ValueSlider>("timelinePosition");
  const int y = slider->height() / 2;
  QTest::mousePress(slider, Qt::LeftButton, Qt::NoModifier, QPoint(slider->width() / 2, y));
  EXPECT_EQ(window->model().frameIndex(), 5);
  const double half = largestDisplacement();
  dragTo(slider, QPoint(slider->width() - 1, y));
  QTest::mouseRelease(slider, Qt::LeftButton, Qt::NoModifier, QPoint(slider->width() - 1, y));
  EXPECT_EQ(window->model().frameIndex(), 10);
  EXPECT_GT(half, 0.1);
  EXPECT_GT(largestDisplacement(), 1.5 * half);
  EXPECT_EQ(find<ValueSlider>("fapSlider19")->shownValue(), 200.0);
  QTest::keyClick(slider, Qt::Key_Left);
  EXPECT_EQ(find<QSpinBox>("timelineFrame")->value(), 10);
}

TEST_F(TimelinePanel, OwnFAPValuesAddToTheAnimation) {
  ASSERT_TRUE(window->openAnimation(writeLids(11, 5)));
  find<QSpinBox>("timelineFrame")->setValue(6);
  const double alone = largestDisplacement();
  find<QDoubleSpinBox>("fapValue19")->setValue(100.0);
  EXPECT_NEAR(largestDisplacement(), 2.0 * alone, 0.05 * alone);
}

TEST_F(TimelinePanel, PlaysAtTheRateOfTheFileAndStopsAtTheEnd) {
  ASSERT_TRUE(window->openAnimation(writeLids(11, 20)));
  find<QToolButton>("timelineLoop")->setChecked(false);
  QElapsedTimer clock;
  clock.start();
  QTest::mouseClick(find<QToolButton>("timelinePlay"), Qt::LeftButton);
  EXPECT_TRUE(window->player().isPlaying());
  ASSERT_TRUE(waitUntil([this] { return !window->player().isPlaying(); }, 20000));
  EXPECT_GE(clock.elapsed(), 500) << "ten frames of 50 ms take no less";
  EXPECT_EQ(window->model().frameIndex(), 10);
}

TEST_F(TimelinePanel, BeginsAgainWhenItLoops) {
  drawViews();
  ASSERT_TRUE(window->openAnimation(writeLids(5, 50)));
  int wraps = 0, last = 0;
  QObject::connect(&window->model(), &mien::FaceModel::stateChanged, [&] {
    wraps += window->model().frameIndex() < last;
    last = window->model().frameIndex();
  });
  window->player().play();
  EXPECT_TRUE(waitUntil([&] { return wraps >= 2; }, 20000));
  QTest::mouseClick(find<QToolButton>("timelinePlay"), Qt::LeftButton);
  EXPECT_FALSE(window->player().isPlaying());
}

TEST_F(TimelinePanel, ClosingTheFileStopsAndShowsTheNeutralFace) {
  ASSERT_TRUE(window->openAnimation(writeLids(100, 50)));
  window->player().play();
  ASSERT_TRUE(waitUntil([this] { return window->model().frameIndex() > 3; }));
  QTest::mouseClick(find<QToolButton>("timelineClose"), Qt::LeftButton);
  EXPECT_FALSE(window->player().isPlaying());
  EXPECT_EQ(window->model().frameCount(), 0);
  EXPECT_EQ(largestDisplacement(), 0.0);
}

TEST_F(TimelinePanel, TheWindowMayCloseWhilePlaying) {
  drawViews();
  ASSERT_TRUE(window->openAnimation(writeLids(100, 50)));
  window->player().play();
  ASSERT_TRUE(waitUntil([this] { return window->model().frameIndex() > 3; }));
  window->close();
  EXPECT_FALSE(window->player().isPlaying());
  window = std::make_unique<mien::StudioWindow>();
  window->show();
  ASSERT_TRUE(window->openAnimation(writeLids(100, 50)));
  window->player().play();
  QTest::qWait(50);
  window.reset();  // without close()
  QTest::qWait(50);
}

TEST_F(TimelinePanel, ABadFileSaysWhyAndChangesNothing) {
  const QString good = writeLids(11, 5);
  ASSERT_TRUE(window->openAnimation(good));
  find<QSpinBox>("timelineFrame")->setValue(6);
  const double before = largestDisplacement();
  const QString bad = QDir(MIEN_TEST_DIR).filePath("data/malformed/fap/line3_one_value_short.fap");
  ASSERT_TRUE(QFile::exists(bad));
  EXPECT_FALSE(window->openAnimation(bad));
  EXPECT_TRUE(message().startsWith(bad + ":3: ")) << message().toStdString();
  EXPECT_EQ(window->model().state().fapFile, good.toStdString());
  EXPECT_EQ(window->model().frameCount(), 11);
  EXPECT_EQ(find<QSpinBox>("timelineFrame")->value(), 6);
  EXPECT_EQ(largestDisplacement(), before);
  QTest::mouseClick(find<QToolButton>("messageClose"), Qt::LeftButton);
  EXPECT_EQ(message(), "");
}

TEST_F(TimelinePanel, AFileThatIsAcceptedWithWarningsSaysSoQuietly) {
  const QString name = writeLids(11, 5);
  QFile file(name);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  QByteArray text = file.readAll();
  file.close();
  text.replace("2.1 lids 5 11", "2.1 lids 5 12");
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(text);
  file.close();
  ASSERT_TRUE(window->openAnimation(name));
  EXPECT_TRUE(message().endsWith(" was opened, with one remark.")) << message().toStdString();
  QTest::mouseClick(find<QToolButton>("messageMore"), Qt::LeftButton);
  auto* details = find<QPlainTextEdit>("messageDetails");
  EXPECT_TRUE(details->isVisible());
  EXPECT_TRUE(details->toPlainText().startsWith(name + ":1: ")) << details->toPlainText().toStdString();
}

TEST_F(TimelinePanel, AnErrorLeavesWhenTheNextFileIsGood) {
  const QString good = writeLids(11, 5);
  EXPECT_FALSE(window->openAnimation("/there/is/no.fap"));
  EXPECT_FALSE(message().isEmpty());
  ASSERT_TRUE(window->openAnimation(good));
  EXPECT_EQ(message(), "");
}

TEST_F(TimelinePanel, AnErrorStaysWhileThePresentAnimationPlaysOnAndLeavesWithTheNextChange) {
  ASSERT_TRUE(window->openAnimation(writeLids(11, 5)));
  EXPECT_FALSE(window->openAnimation("/there/is/no.fap"));
  window->model().showFrame(5);
  settle();
  EXPECT_FALSE(message().isEmpty());
  find<QDoubleSpinBox>("fapValue33")->setValue(100.0);
  settle();
  EXPECT_EQ(message(), "");
}

TEST_F(TimelinePanel, FAPsWithoutSurfaceAreSaidOnceWithoutDetails) {
  const QString name = writeLids(11, 5);
  QFile file(name);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  QByteArray text = file.readAll();
  file.close();
  text.replace("0 0 0 1 0 0 0 0", "0 0 0 1 0 0 0 1");  // FAP 23 beside FAP 19
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  for (const QByteArray& line : text.split('\n')) {
    const QList<QByteArray> words = line.simplified().split(' ');
    file.write(words.size() == 2 ? line + " 50\n" : line + "\n");
  }
  file.close();
  ASSERT_TRUE(window->openAnimation(name));
  EXPECT_TRUE(message().endsWith(" was opened. It also sets FAP 23 (eyeballs), which this face has no surface for."))
      << message().toStdString();
  EXPECT_FALSE(find<QToolButton>("messageMore")->isVisible());
  QTest::mouseClick(find<QToolButton>("messageClose"), Qt::LeftButton);
  window->model().showFrame(5);
  settle();
  EXPECT_EQ(message(), "");
}

TEST_F(TimelinePanel, ADroppedFilePlays) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(writeLids(100, 25))});
  QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(window.get(), &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(window.get(), &drop);
  EXPECT_EQ(window->model().frameCount(), 100);
  EXPECT_TRUE(window->player().isPlaying());
}

TEST_F(TimelinePanel, AFileThatWasOverwrittenIsReadAnew) {
  const QString name = writeLids(11, 5);
  ASSERT_TRUE(window->openAnimation(name));
  window->model().showFrame(4);
  writeLids(20, 10);
  ASSERT_TRUE(window->openAnimation(name));
  EXPECT_EQ(window->model().motion().frames.size(), 20u);
  EXPECT_EQ(window->player().rangeEnd(), 19);
  EXPECT_EQ(find<ValueSlider>("timelinePosition")->maximum(), 19);
  find<QSpinBox>("timelineFrame")->setValue(20);
  EXPECT_EQ(window->model().frameNumber(), "19");
  EXPECT_EQ(find<QSpinBox>("timelineFrame")->text(), "19 / 19");
  EXPECT_EQ(window->model().shownFAP(19), 380.0);
  EXPECT_EQ(find<QLabel>("timelineTime")->text(), QString(u8"1.90 s of 1.90 s \u00b7 10 frames/s"));
}

/// Frames whose numbers repeat, and of more digits than six.
TEST_F(TimelinePanel, TheNumberOfTheFrameShownMeansThisFrame) {
  const QString name = writeLids(3, 5);
  QFile file(name);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  QByteArray text = file.readAll();
  file.close();
  for (const char* line : {"\n0 0\n", "\n1 20\n", "\n2 40\n"}) {
    ASSERT_EQ(text.count(line), 1) << line;
    text.replace(line, QByteArray(line).replace(1, 1, "1000070"));
  }
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(text);
  file.close();
  ASSERT_TRUE(window->openAnimation(name));
  window->model().showFrame(2);
  auto* box = find<QSpinBox>("timelineFrame");
  EXPECT_EQ(box->text(), "1000070 / 1000070");
  box->interpretText();
  EXPECT_EQ(box->value(), 3);
}

TEST_F(TimelinePanel, AFileThatWasOverwrittenWithNonsenseStaysAsItWasRead) {
  const QString name = writeLids(11, 5);
  ASSERT_TRUE(window->openAnimation(name));
  window->model().showFrame(4);
  settle();
  QFile file(name);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("2.1 lids 5 1\nno mask\n");
  file.close();
  EXPECT_FALSE(window->openAnimation(name));
  EXPECT_TRUE(message().startsWith(name + ":2: ")) << message().toStdString();
  EXPECT_EQ(window->model().frameCount(), 11);
  EXPECT_EQ(window->model().frameIndex(), 4);
  EXPECT_EQ(window->model().shownFAP(19), 80.0);
  EXPECT_GT(largestMovement(), 0.1);
}

/// The pipeline runs for every frame, the views for none of them.
/// Between the darkest and the lightest pixel inside a button's frame, 0 .. 255.
int contrastOf(QWidget* button) {
  const QImage image = button->grab(button->rect().adjusted(5, 5, -5, -5)).toImage();
  int darkest = 255, lightest = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const int gray = qGray(image.pixel(x, y));
      darkest = std::min(darkest, gray);
      lightest = std::max(lightest, gray);
    }
  return lightest - darkest;
}

TEST_F(TimelinePanel, IconsStandOutFromTheirButtonsPressedOrNot) {
  ASSERT_TRUE(window->openAnimation(writeLids(10, 20)));
  auto* loop = find<QToolButton>("timelineLoop");
  for (const bool isPressed : {true, false}) {
    loop->setChecked(isPressed);
    settle();
    EXPECT_GT(contrastOf(loop), 100) << (isPressed ? "pressed" : "not pressed");
  }
}

TEST_F(TimelinePanel, RealFilesOpenAndMoveTheFace) {
  for (const char* name : {"7_basic_emotion.fap", "basic_emotion.fap"}) {
    const QString file = QString(MIEN_REFERENCE_DIR) + "/faps/" + name;
    if (!QFile::exists(file)) GTEST_SKIP() << file.toStdString() << " is not there";
    ASSERT_TRUE(window->openAnimation(file)) << message().toStdString();
    double most = 0.0;
    for (int frame = 0; frame < window->model().frameCount(); ++frame) {
      window->model().showFrame(frame);
      ASSERT_TRUE(window->model().update());
      most = std::max(most, largestMovement());
    }
    EXPECT_GT(most, 1.0) << name;
  }
}

}  // namespace
