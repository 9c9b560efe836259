#include <QApplication>
#include <QEvent>
#include <QTabBar>
#include <QToolButton>

#include "StudioFixture.h"

namespace {

/// Counts what keeps a processor busy.
class WorkCounter : public QObject {
 public:
  int laidOut = 0, painted = 0;

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    laidOut += event->type() == QEvent::LayoutRequest;
    painted += event->type() == QEvent::UpdateRequest;
    return false;
  }
};

/// A window at which nobody does anything does nothing.
class IdleWindow : public StudioFixture {
 protected:
  void rest(int milliseconds) {
    settle();
    QTest::qWait(milliseconds);
  }

  void expectIdle(const std::string& when) {
    const auto isStill = [&] {  // docks compute and glide into their places for some time
      WorkCounter counter;
      qApp->installEventFilter(&counter);
      rest(400);
      return counter.laidOut == 0 && counter.painted == 0;
    };
    EXPECT_TRUE(waitUntil(isStill)) << when << ": it lays out or draws again and again";
  }
};

TEST_F(IdleWindow, NeitherLaysOutNorDrawsAgainInAnyWorkspace) {
  for (const QSize& size : {QSize(1280, 800), QSize(1000, 700), QSize(1600, 1000)})
    for (int workspace : {0, 1, 2, 3}) {
      find<QTabBar>("workspaces")->setCurrentIndex(workspace);
      window->resize(size);
      expectIdle("workspace " + std::to_string(workspace) + " at " + std::to_string(size.width()));
    }
}

TEST_F(IdleWindow, NorWithAllFAPs) {
  find<QToolButton>("fapAll")->click();
  for (int height : {700, 800, 1000}) {
    window->resize(1280, height);
    expectIdle("all FAPs at " + std::to_string(height));
  }
}

}  // namespace
