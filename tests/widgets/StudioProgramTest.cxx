#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "OtherWindow.h"
#include "SessionFile.h"
#include "StudioWindow.h"

namespace {

using nlohmann::json;

constexpr int programWait = 60000, attempt = 10000;  // ms, of a busy machine
constexpr int attempts = 6;

/// Where a widget is in a window as it first starts.
QPoint placeOf(const char* name) {
  mien::StudioWindow window;
  for (const char* view : {"faceView", "curveView"}) window.findChild<QWidget*>(view)->setUpdatesEnabled(false);
  window.show();
  EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
  auto* widget = window.findChild<QWidget*>(name);
  return widget->mapTo(&window, widget->rect().center());
}

/// Mien Studio itself as a process, with folders of its own.
class StudioProgram : public testing::Test {
 protected:
  struct Running {
    std::unique_ptr<QProcess> process;
    std::unique_ptr<OtherWindow> window;
    Running(Running&&) = default;
    explicit Running(std::unique_ptr<QProcess> begun)
        : process(std::move(begun)), window(std::make_unique<OtherWindow>(process->processId())) {}
    ~Running() {
      if (!process) return;
      process->kill();  // SIGKILL
      process->waitForFinished();
    }
  };

  /// Not the first start, which has a tour over the window.
  StudioProgram() {
    QSettings(settings.path() + "/mien/mien-studio.conf", QSettings::IniFormat).setValue("window/tourSeen", true);
  }

  std::unique_ptr<QProcess> begin(const QStringList& arguments) const {
    auto process = std::make_unique<QProcess>();
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("XDG_DATA_HOME", data.path());
    environment.insert("XDG_CONFIG_HOME", settings.path());
    process->setProcessEnvironment(environment);
    process->start(MIEN_STUDIO, arguments);
    return process;
  }

  Running start(const QStringList& arguments = {}) const {
    auto process = begin(arguments);
    EXPECT_TRUE(process->waitForStarted());
    Running running(std::move(process));
    EXPECT_TRUE(QTest::qWaitFor([&] { return running.window->isVisible(); }, programWait));
    return running;
  }

  QStringList kept() const {
    const QDir folder(data.path() + "/mien/mien-studio/autosave");
    QStringList files;
    for (const QString& name : folder.entryList({QString("*") + mien::SessionFile::ending}, QDir::Files))
      files << folder.filePath(name);
    return files;
  }

  static json faceIn(const QString& file) {
    json session;
    EXPECT_EQ(mien::SessionFile::read(file, session).toStdString(), "");
    return session.value("face", json());
  }

  /// A program that still begins loses what is done to its window.
  static bool repeat(const std::function<void()>& act, const std::function<bool()>& done) {
    for (int i = 0; i < attempts; ++i) {
      act();
      if (QTest::qWaitFor(done, attempt)) return true;
    }
    return false;
  }

  QTemporaryDir data, settings;
};

TEST_F(StudioProgram, OffersWhatItShowedWhenItWasKilledAndRestoresIt) {
  const QPoint joy = placeOf("expression_joy");
  QString before;
  json face;
  {
    const Running studio = start();
    ASSERT_TRUE(repeat([&] { studio.window->click(joy); }, [this] { return kept().size() == 1; }));
    before = kept().front();
    face = faceIn(before);
  }
  EXPECT_EQ(face["expressions"], json({{"joy", 1.0}}));
  ASSERT_EQ(kept(), QStringList(before)) << "it outlasts its process";
  const Running again = start();
  const auto isRestored = [&] { return kept().size() == 1 && kept().front() != before; };
  ASSERT_TRUE(repeat([&] { again.window->pressAlt('s'); }, isRestored)) << "the bar has the button Restore";
  EXPECT_EQ(faceIn(kept().front()), face);
}

/// The display of the tests, 1920 x 1200, has 1280 x 800 pixels of this size, some of which a desktop needs for titles.
TEST_F(StudioProgram, FitsOntoASmallScreenOfLargePixels) {
  const QString file = data.filePath("window.png");
  qputenv("QT_SCALE_FACTOR", "1.5");
  const auto process = begin({"--picture", file});
  qunsetenv("QT_SCALE_FACTOR");
  ASSERT_TRUE(process->waitForFinished(programWait)) << process->errorString().toStdString();
  const QImage picture(file);
  EXPECT_EQ(picture.width(), 1920);
  EXPECT_GT(picture.height(), 1000);
  EXPECT_LE(picture.height(), 1200 - 1.5 * 37);
}

TEST_F(StudioProgram, OpensItsWindowWithADamagedSession) {
  const QString damaged = data.filePath(QString("damaged") + mien::SessionFile::ending);
  ASSERT_TRUE(QFile::copy(MIEN_TEST_DIR "/data/malformed/session/line3_cut_off.json", damaged));
  const Running studio = start({damaged});
  EXPECT_TRUE(studio.window->isVisible());
  EXPECT_FALSE(studio.process->waitForFinished(1000));
  const auto picture = begin({"--picture", data.filePath("window.png"), damaged});
  ASSERT_TRUE(picture->waitForFinished(programWait));
  EXPECT_EQ(picture->exitCode(), 1);
  EXPECT_EQ(
      picture->readAllStandardError().toStdString(),
      "mien-studio: damaged.mien-session.json cannot be opened: it ends at line 3 (cut off?); open an earlier copy; "
      "nothing was changed\n");
}

}  // namespace
