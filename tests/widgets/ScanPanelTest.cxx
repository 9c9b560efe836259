#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QFile>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QTemporaryDir>
#include <QToolButton>

#include "BoundaryCurveData.h"
#include "FaceModel.h"
#include "ReferenceData.h"
#include "ScanPanel.h"
#include "StudioFixture.h"

namespace {

constexpr int longest = 120000;  // ms for measuring a scan on a busy machine

class ScanPanel : public StudioFixture {
 protected:
  ScanPanel() {
    find<QAction>("curvesDockAction")->trigger();
    settle();
    panel = find<mien::ScanPanel>("scanPanel");
  }

  QString report() { return find<QPlainTextEdit>("scanReport")->toPlainText(); }
  void openSubject() {
    panel->openLandmarks(QString::fromStdString(referencePath("heads/landmarks68.csv")));
    panel->open(QString::fromStdString(referencePath("heads/subject01_neutral.ply")));
  }

  mien::ScanPanel* panel = nullptr;
};

TEST_F(ScanPanel, AFileThatIsNoScanIsNamed) {
  QTemporaryDir folder;
  QFile file(folder.filePath("nothing.ply"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("this is no mesh");
  file.close();
  panel->open(file.fileName());
  ASSERT_TRUE(waitUntil([&] { return !panel->isMeasuring(); }, longest));
  EXPECT_TRUE(message().contains("nothing.ply")) << message().toStdString();
  EXPECT_FALSE(panel->hasScan());
  EXPECT_FALSE(find<QToolButton>("scanAdopt")->isEnabled());
  EXPECT_FALSE(find<QComboBox>("scanDistances")->isEnabled());
}

TEST_F(ScanPanel, AScanIsMeasuredAdoptedAndCompared) {
  MIEN_REQUIRE_REFERENCE("heads/subject01_neutral.ply");
  openSubject();
  EXPECT_TRUE(find<QToolButton>("scanCancel")->isVisible());
  ASSERT_TRUE(waitUntil([&] { return panel->hasScan(); }, longest));
  EXPECT_EQ(message(), "");
  EXPECT_TRUE(report().contains("landmarks  given")) << report().toStdString();
  EXPECT_TRUE(report().contains("unit       mm")) << report().toStdString();
  find<QComboBox>("scanDistances")->setCurrentIndex(1);
  ASSERT_TRUE(waitUntil([&] { return report().startsWith("Face to scan"); }, longest));
  const auto rms = [&] { return report().section("RMS ", 1).section(" ", 0, 0).toDouble(); };
  const double before = rms();
  QTemporaryDir folder;
  EXPECT_FALSE(panel->adopt(folder.filePath("there_is_no_folder/anna.vtp")));
  EXPECT_TRUE(message().contains("there_is_no_folder"));
  ASSERT_TRUE(panel->adopt(folder.filePath("anna.vtp")));
  EXPECT_EQ(window->model().state().curvesFile, folder.filePath("anna.vtp").toStdString());
  ASSERT_TRUE(waitUntil([&] { return rms() < 0.7; }, longest)) << report().toStdString();
  EXPECT_GT(before, 2.0 * rms());
  find<QComboBox>("scanDistances")->setCurrentIndex(2);
  ASSERT_TRUE(waitUntil([&] { return report().startsWith("Scan to face"); }, longest));
  find<QComboBox>("scanDistances")->setCurrentIndex(0);
  EXPECT_TRUE(waitUntil([&] { return report().startsWith("/") || !report().contains("RMS, median"); }));
}

TEST_F(ScanPanel, CancellingLeavesNoScan) {
  MIEN_REQUIRE_REFERENCE("heads/subject01_neutral.ply");
  panel->open(QString::fromStdString(referencePath("heads/subject01_neutral.ply")));
  QTest::mouseClick(find<QToolButton>("scanCancel"), Qt::LeftButton);
  ASSERT_TRUE(waitUntil([&] { return !panel->isMeasuring(); }, longest));
  EXPECT_FALSE(panel->hasScan());
  EXPECT_EQ(message(), "");
}

TEST_F(ScanPanel, AWindowMayCloseMeanwhile) {
  MIEN_REQUIRE_REFERENCE("heads/subject01_neutral.ply");
  panel->open(QString::fromStdString(referencePath("heads/subject01_neutral.ply")));
  EXPECT_TRUE(panel->isMeasuring());
  window.reset();
}

}  // namespace
