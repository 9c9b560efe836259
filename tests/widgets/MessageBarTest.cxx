#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QToolButton>
#include <QTreeWidget>

#include "FaceModel.h"
#include "MessageBar.h"
#include "StudioFixture.h"

namespace {

using MessageBar = StudioFixture;

TEST_F(MessageBar, AnErrorGoesWithTheNextSuccessAndStaysInTheLog) {
  EXPECT_FALSE(window->openAnimation("no_such_file.fap"));
  settle();
  const QString said = message();
  EXPECT_FALSE(said.isEmpty());
  EXPECT_TRUE(window->openAnimation(writeLids(3, 25)));
  settle();
  EXPECT_EQ(message(), "");
  const auto& log = find<mien::MessageBar>("messageBar")->log();
  ASSERT_EQ(log.size(), 1u);
  EXPECT_TRUE(log[0].isError);
  EXPECT_EQ(log[0].sentence, said);
}

/// The face must not jump while it is looked at.
TEST_F(MessageBar, NothingMovesWhenAMessageComesAndGoes) {
  const char* const names[] = {"faceView", "curveView", "viewArea", "timelinePanel"};
  const auto places = [&] {
    settle();
    std::vector<QRect> all;
    for (const char* name : names) {
      auto* widget = find<QWidget>(name);
      all.emplace_back(widget->mapTo(window.get(), QPoint()), widget->size());
    }
    return all;
  };
  auto* bar = find<mien::MessageBar>("messageBar");
  for (const QSize& size : {QSize(1280, 800), QSize(1024, 700)}) {
    window->resize(size);
    const std::vector<QRect> before = places();
    bar->showError(QString("A long sentence about a file. ").repeated(8), "line 1\nline 2");
    EXPECT_EQ(places(), before);
    const QRect views(before[2]), shown(bar->mapTo(window.get(), QPoint()), bar->size());
    EXPECT_TRUE(views.contains(shown)) << "over the views";
    find<QToolButton>("messageMore")->click();
    EXPECT_EQ(places(), before);
    EXPECT_GT(bar->height(), shown.height());
    QTest::mouseClick(find<QToolButton>("messageClose"), Qt::LeftButton);
    EXPECT_EQ(places(), before);
    EXPECT_FALSE(bar->isVisible());
  }
}

TEST_F(MessageBar, ANoteLeavesByItselfAndAnErrorStays) {
  auto* bar = find<mien::MessageBar>("messageBar");
  const int some = mien::MessageBar::noteTime + 1000;
  bar->showNote("One was written.", "/somewhere/one");
  EXPECT_TRUE(bar->isVisible());
  EXPECT_TRUE(waitUntil([&] { return !bar->isVisible(); }, 2 * some));
  bar->showNote("Two was written.", "/somewhere/two");
  find<QToolButton>("messageMore")->click();
  QTest::qWait(some);
  EXPECT_TRUE(bar->isVisible()) << "while its details are read";
  bar->showError("Three is damaged", "line 3");
  QTest::qWait(some);
  EXPECT_TRUE(bar->isVisible());
}

TEST_F(MessageBar, ANoteIsAsWideAsItsTextAndCoversNoKey) {
  auto* bar = find<mien::MessageBar>("messageBar");
  bar->showNote("One was written.", QString());
  settle();
  EXPECT_LT(bar->width(), 400);
  const int bottom = bar->mapTo(window.get(), QPoint(0, bar->height())).y();
  EXPECT_LE(bottom, find<QWidget>("curveScale")->mapTo(window.get(), QPoint()).y());
  const int narrow = bar->width();
  bar->showNote(QString("Many words were written. ").repeated(3), QString());
  settle();
  EXPECT_GT(bar->width(), narrow + 100);
}

TEST_F(MessageBar, TheLogShowsTheNewestFirstWithDetailsAndIsCopied) {
  auto* bar = find<mien::MessageBar>("messageBar");
  bar->showNote("One was written.", "/somewhere/one");
  find<QAction>("actionMessages")->trigger();
  bar->showError("Two is damaged", "line 3");
  auto* list = window->findChild<QTreeWidget*>("messageLogList");
  ASSERT_EQ(list->topLevelItemCount(), 2);
  EXPECT_EQ(list->topLevelItem(0)->text(2), "Two is damaged");
  list->setCurrentItem(list->topLevelItem(1));
  EXPECT_EQ(window->findChild<QPlainTextEdit*>("messageLogDetails")->toPlainText(),
            "One was written.\n\n/somewhere/one");
  window->findChild<QPushButton*>("messageLogCopy")->click();
  const QString text = QGuiApplication::clipboard()->text();
  EXPECT_LT(text.indexOf("One was written."), text.indexOf("Two is damaged"));
}

TEST_F(MessageBar, TheLogForgetsTheOldest) {
  auto* bar = find<mien::MessageBar>("messageBar");
  for (int i = 0; i < mien::MessageBar::mostKept + 20; ++i) bar->showNote(QString::number(i), QString());
  EXPECT_EQ(bar->log().size(), static_cast<size_t>(mien::MessageBar::mostKept));
  EXPECT_EQ(bar->log().front().sentence, "20");
}

}  // namespace
