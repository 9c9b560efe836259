#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QCoreApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QFrame>
#include <QLabel>
#include <QMenu>
#include <QProcess>
#include <QPushButton>
#include <QSettings>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <memory>
#include <nlohmann/json.hpp>

#include "Autosave.h"
#include "FaceModel.h"
#include "FaceStateText.h"
#include "MessageBar.h"
#include "SessionDocument.h"
#include "SessionFile.h"
#include "StudioWindow.h"
#include "Tour.h"

namespace {

constexpr int longWait = 60000;  // ms, of a busy machine
constexpr const char* childState = "MIEN_TEST_CHILD_STATE";

std::unique_ptr<mien::StudioWindow> start() {
  auto window = std::make_unique<mien::StudioWindow>();
  for (const char* view : {"faceView", "curveView"}) window->findChild<QWidget*>(view)->setUpdatesEnabled(false);
  window->show();
  EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
  return window;
}

std::string stateOf(mien::StudioWindow& window) {
  return mien::writeFaceState(window.model().state());
}

void changeByHand(mien::StudioWindow& window) {
  QTest::mouseClick(window.findChild<QPushButton*>("expression_joy"), Qt::LeftButton);
  QTest::keyClick(window.findChild<QComboBox*>("faceMesh"), Qt::Key_Down);
  QTest::qWait(0);
}

/// As the program names itself, with folders of its own.
class Recovery : public testing::Test {
 protected:
  Recovery() {
    qputenv("XDG_DATA_HOME", data.path().toUtf8());
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
    QCoreApplication::setOrganizationName("mien");
    QCoreApplication::setApplicationName("mien-studio");
  }
  ~Recovery() override { QCoreApplication::setOrganizationName(QString()); }

  static QStringList kept() {
    return QDir(mien::Autosave::usualFolder()).entryList({QString("*") + mien::SessionFile::ending}, QDir::Files);
  }
  /// As a process left it that was killed. @return its file
  static QString keep(const QString& name, const QByteArray& text) {
    const QDir folder(mien::Autosave::usualFolder());
    folder.mkpath(".");
    QFile file(folder.filePath(name + mien::SessionFile::ending));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
    return file.fileName();
  }

  /// What the file of this process holds; null until there is one.
  static nlohmann::json keptSession() {
    nlohmann::json session;
    if (kept().size() == 1)
      mien::SessionFile::read(QDir(mien::Autosave::usualFolder()).filePath(kept().front()), session);
    return session;
  }

  static QString said(mien::StudioWindow& window) {
    const auto* messages = window.findChild<mien::MessageBar*>();
    return messages->isVisible() ? messages->sentence() : QString();
  }

  static QFrame* bar(mien::StudioWindow& window) { return window.findChild<QFrame*>("recoveryBar"); }

  QTemporaryDir data, settings;
};

/// Not a test: the program that is killed. It changes its face, tells it and waits.
TEST(RecoveryChild, DISABLED_ChangesTheFaceAndWaits) {
  QCoreApplication::setOrganizationName("mien");
  QCoreApplication::setApplicationName("mien-studio");
  const auto window = start();
  changeByHand(*window);
  window->model().update();
  QFile told(qEnvironmentVariable(childState));
  ASSERT_TRUE(told.open(QIODevice::WriteOnly));
  told.write(QByteArray::fromStdString(stateOf(*window)));
  told.close();
  QTest::qWait(longWait);
}

class Killed : public Recovery {
 protected:
  Killed() {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(childState, data.filePath("state.json"));
    child.setProcessEnvironment(environment);
    child.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    child.start(QCoreApplication::applicationFilePath(),
                {"--gtest_filter=RecoveryChild.*", "--gtest_also_run_disabled_tests"});
  }
  ~Killed() override {
    child.kill();
    child.waitForFinished();
  }

  QByteArray told() const {
    QFile file(data.filePath("state.json"));
    file.open(QIODevice::ReadOnly);
    return file.readAll();
  }

  QProcess child;
};

TEST_F(Killed, WhatItShowedIsOfferedAtTheNextStartAndRestored) {
  ASSERT_TRUE(QTest::qWaitFor([] { return !kept().isEmpty(); }, longWait));
  ASSERT_NE(told(), QByteArray());
  EXPECT_FALSE(bar(*start())->isVisible()) << "while it is alive";
  child.kill();  // SIGKILL
  ASSERT_TRUE(child.waitForFinished());
  const auto window = start();
  ASSERT_TRUE(bar(*window)->isVisible());
  EXPECT_TRUE(window->findChild<QLabel*>("recoverySentence")->text().startsWith("Mien Studio ended unexpectedly"));
  EXPECT_FALSE(bar(*start())->isVisible()) << "in a second window that starts meanwhile";
  QTest::mouseClick(window->findChild<QToolButton*>("recoveryRestore"), Qt::LeftButton);
  EXPECT_EQ(stateOf(*window), told().toStdString());
  EXPECT_EQ(window->findChild<QComboBox*>("faceMesh")->currentIndex(), 1);
  EXPECT_TRUE(window->document().isModified());
  EXPECT_FALSE(bar(*window)->isVisible());
  EXPECT_EQ(kept(), QStringList());
}

TEST_F(Killed, WhatIsDiscardedIsNotOfferedAgain) {
  ASSERT_TRUE(QTest::qWaitFor([] { return !kept().isEmpty(); }, longWait));
  child.kill();
  ASSERT_TRUE(child.waitForFinished());
  {
    const auto window = start();
    QTest::mouseClick(window->findChild<QToolButton*>("recoveryDiscard"), Qt::LeftButton);
    EXPECT_FALSE(bar(*window)->isVisible());
    EXPECT_EQ(window->model().state(), mien::FaceState());
  }
  EXPECT_EQ(kept(), QStringList());
  EXPECT_FALSE(bar(*start())->isVisible());
}

TEST_F(Recovery, NothingIsLeftAfterAnEndInGoodOrder) {
  auto window = start();
  EXPECT_EQ(kept(), QStringList());
  changeByHand(*window);
  ASSERT_TRUE(QTest::qWaitFor([] { return kept().size() == 1; }, longWait));
  window.reset();
  EXPECT_EQ(kept(), QStringList());
}

TEST_F(Recovery, CamerasAndTheWorkspaceAreKeptToo) {
  const auto window = start();
  QApplication::setActiveWindow(window.get());
  window->findChild<QToolButton*>("lookSide")->click();
  ASSERT_TRUE(QTest::qWaitFor([] { return kept().size() == 1; }, longWait)) << "a camera that was moved is lost";
  for (const char* how : {"tab", "keys"}) {
    const nlohmann::json before = keptSession();
    if (how == std::string("tab"))
      window->findChild<QTabBar*>("workspaces")->setCurrentIndex(2);
    else
      QTest::keyClick(window.get(), Qt::Key_F1, Qt::ControlModifier);
    EXPECT_TRUE(QTest::qWaitFor([&] { return keptSession() != before; }, longWait)) << how;
  }
}

TEST_F(Recovery, NothingIsOfferedOfWhatWasSaved) {
  const auto window = start();
  changeByHand(*window);
  ASSERT_TRUE(QTest::qWaitFor([] { return kept().size() == 1; }, longWait));
  ASSERT_TRUE(window->document().save(data.filePath("joy.mien-session.json")));
  EXPECT_EQ(kept(), QStringList());
  QTest::qWait(mien::Autosave::interval + 500);
  EXPECT_EQ(kept(), QStringList());
  changeByHand(*window);
  EXPECT_TRUE(QTest::qWaitFor([] { return kept().size() == 1; }, longWait));
}

TEST_F(Recovery, OfADamagedFileSaysSoOnceAndPutsItAside) {
  const QString name = keep("a", "{\"format\": \"mien sess");
  {
    const auto window = start();
    EXPECT_FALSE(bar(*window)->isVisible());
    EXPECT_TRUE(said(*window).contains("put aside")) << said(*window).toStdString();
    const QString details = window->findChild<mien::MessageBar*>()->log().back().details;
    EXPECT_TRUE(details.contains("ends at line 1 (cut off?)")) << details.toStdString();
    EXPECT_TRUE(details.contains(name + ".damaged")) << details.toStdString();
    EXPECT_EQ(window->model().state(), mien::FaceState());
  }
  EXPECT_EQ(kept(), QStringList());
  QFile aside(name + ".damaged");
  ASSERT_TRUE(aside.open(QIODevice::ReadOnly));
  EXPECT_EQ(aside.readAll(), "{\"format\": \"mien sess");
  EXPECT_EQ(said(*start()), "");
}

TEST_F(Recovery, OneThatIsWholeButCannotBeShownIsPutAsideAndTheNextOneOffered) {
  keep("a", "{\"format\": \"mien session\", \"version\": 1, \"face\": 7}");
  QTest::qWait(20);
  keep("b", "{\"format\": \"mien session\", \"version\": 1}");
  const auto window = start();
  ASSERT_TRUE(bar(*window)->isVisible());
  auto* restore = window->findChild<QToolButton*>("recoveryRestore");
  QTest::mouseClick(restore, Qt::LeftButton);
  EXPECT_TRUE(said(*window).contains("cannot be opened")) << said(*window).toStdString();
  EXPECT_TRUE(bar(*window)->isVisible());
  QTest::mouseClick(restore, Qt::LeftButton);
  EXPECT_FALSE(bar(*window)->isVisible());
  EXPECT_EQ(kept(), QStringList());
}

/// By the keyboard as by the mouse: what the user goes on with is the face.
TEST_F(Recovery, GivesTheFocusToTheFaceOnceItIsAnswered) {
  for (const char* answer : {"recoveryRestore", "recoveryDiscard"}) {
    keep("a", "{\"format\": \"mien session\", \"version\": 1}");
    const auto window = start();
    QApplication::setActiveWindow(window.get());
    ASSERT_TRUE(bar(*window)->isVisible());
    auto* button = window->findChild<QToolButton*>(answer);
    button->setFocus();
    ASSERT_EQ(window->focusWidget(), button);
    QTest::keyClick(button, Qt::Key_Space);
    EXPECT_FALSE(bar(*window)->isVisible());
    EXPECT_EQ(window->focusWidget(), window->findChild<QWidget*>("faceView")) << answer;
  }
}

TEST_F(Recovery, BringsTheNameOfTheSessionBack) {
  const QString session = data.filePath("joy.mien-session.json");
  QByteArray text;
  {
    const auto window = start();
    ASSERT_TRUE(window->document().save(session));
    changeByHand(*window);
    ASSERT_TRUE(QTest::qWaitFor([] { return kept().size() == 1; }, longWait));
    QFile file(QDir(mien::Autosave::usualFolder()).filePath(kept().front()));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    text = file.readAll();
  }
  keep("killed", text);
  const auto window = start();
  EXPECT_TRUE(window->findChild<QLabel*>("recoverySentence")->text().contains("joy.mien-session.json"));
  QTest::mouseClick(window->findChild<QToolButton*>("recoveryRestore"), Qt::LeftButton);
  EXPECT_EQ(window->windowTitle().toStdString(), "joy.mien-session.json (recovered)[*]");
  EXPECT_TRUE(window->isWindowModified());
  EXPECT_EQ(window->document().fileName(), session);
  ASSERT_TRUE(window->document().save());
  EXPECT_EQ(window->windowTitle().toStdString(), "joy.mien-session.json[*]");
  window->findChild<QAction*>("actionNewSession")->trigger();
  EXPECT_EQ(window->windowTitle().toStdString(), "New session[*]");
}

/// By another window, say: between the last sight of a file and saving, also where a crash lies between.
TEST_F(Recovery, WhatOthersWroteIntoTheFileIsNotReplacedWithoutAWord) {
  const QString session = data.filePath("joy.mien-session.json");
  const auto written = [&](const QByteArray& text) {
    QFile file(session);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
  };
  int warned = 0;
  bool goesOn = false;
  const auto warn = [&] { return ++warned, goesOn; };
  QByteArray text;
  {
    const auto window = start();
    window->document().setWarning(warn);
    ASSERT_TRUE(window->document().save(session));
    ASSERT_TRUE(window->document().save());
    EXPECT_EQ(warned, 0) << "of what it wrote itself";
    changeByHand(*window);
    ASSERT_TRUE(QTest::qWaitFor([] { return kept().size() == 1; }, longWait));
    text = QByteArray::fromStdString(keptSession().dump());
    written("other");
    EXPECT_FALSE(window->document().save());
    EXPECT_EQ(warned, 1);
    EXPECT_TRUE(window->isWindowModified());
  }
  EXPECT_EQ(QFileInfo(session).size(), 5);
  keep("killed", text);
  const auto window = start();
  window->document().setWarning(warn);
  QTest::mouseClick(window->findChild<QToolButton*>("recoveryRestore"), Qt::LeftButton);
  EXPECT_FALSE(window->document().save());
  EXPECT_EQ(warned, 2);
  goesOn = true;
  EXPECT_TRUE(window->document().save());
  EXPECT_GT(QFileInfo(session).size(), 1000);
  EXPECT_TRUE(window->document().save());
  EXPECT_EQ(warned, 3);
}

TEST_F(Recovery, IsOfferedBeforeTheTour) {
  const QString name = keep("a", "{\"format\": \"mien session\", \"version\": 1}");
  const auto hasTour = [](mien::StudioWindow& window) {
    mien::Tour::showAtFirstStart(window);
    QTest::qWait(50);
    return window.findChild<QWidget*>("tour") != nullptr;
  };
  EXPECT_FALSE(hasTour(*start()));
  QFile::remove(name);
  EXPECT_TRUE(hasTour(*start())) << "at the next start";
}

TEST_F(Recovery, RecentFilesAreRememberedAndOpenedFromTheMenu) {
  const QString session = data.filePath("joy.mien-session.json"), gone = data.filePath("gone.mien-session.json");
  {
    const auto window = start();
    changeByHand(*window);
    window->model().update();
    ASSERT_TRUE(window->document().save(gone));
    ASSERT_TRUE(window->document().save(session));
  }
  QFile::remove(gone);
  const auto window = start();
  auto* menu = window->findChild<QMenu*>("recentMenu");
  ASSERT_GE(menu->actions().size(), 3);
  EXPECT_EQ(menu->actions()[0]->text().toStdString(), "&1 joy.mien-session.json");
  EXPECT_EQ(menu->actions()[1]->toolTip(), gone);
  menu->actions()[1]->trigger();
  EXPECT_TRUE(window->findChild<QLabel*>("messageSentence")->text().startsWith("gone.mien-session.json is not there"));
  QTest::qWait(0);
  menu->actions()[0]->trigger();
  EXPECT_EQ(window->model().state().expressions.at("joy"), 1.0);
  window->findChild<QAction*>("actionClearRecent")->trigger();
  QTest::qWait(0);
  EXPECT_FALSE(menu->menuAction()->isEnabled());
}

}  // namespace
