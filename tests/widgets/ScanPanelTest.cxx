#include <gtest/gtest.h>
#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTextStream>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "BoundaryCurveData.h"
#include "ColorKey.h"
#include "DenseFace.h"
#include "FaceColoring.h"
#include "FaceModel.h"
#include "FaceView.h"
#include "ReferenceData.h"
#include "ScanPanel.h"
#include "SessionDocument.h"
#include "StudioFixture.h"
#include "ViewArea.h"

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

  /// As .obj, with more of its lines behind.
  static void writeScan(const DenseFace& scan, const QString& name, const char* more = "") {
    QFile file(name);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly | QIODevice::Text));
    QTextStream text(&file);
    for (const auto& p : scan.mesh.vertices.rowwise()) text << "v " << p[0] << " " << p[1] << " " << p[2] << "\n";
    for (const auto& t : scan.mesh.triangles.rowwise())
      text << "f " << t[0] + 1 << " " << t[1] + 1 << " " << t[2] + 1 << "\n";
    text << more;
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
  EXPECT_FALSE(report().contains("inwards") || report().contains("larger")) << "nothing is doubtful";
  EXPECT_TRUE(report().contains("Landmarks  from the file, ")) << report().toStdString();
  EXPECT_TRUE(report().contains("Mesh       in mm, recognised by the size of the head; ")) << report().toStdString();
  EXPECT_TRUE(report().startsWith("Curves measured from subject01_neutral.ply, not adopted yet:"))
      << report().toStdString();
  EXPECT_TRUE(report().contains(QRegularExpression("lies [0-9.]+ mm RMS from the scan, [0-9.]+ mm at most\n")));
  find<QComboBox>("scanDistances")->setCurrentIndex(1);
  ASSERT_TRUE(waitUntil([&] { return report().startsWith("Shown face to scan"); }, longest));
  const auto rms = [&] { return report().section("RMS ", 1).section(" ", 0, 0).toDouble(); };
  const double before = rms();
  QTemporaryDir folder;
  EXPECT_FALSE(panel->adopt(folder.filePath("there_is_no_folder/anna.vtp")));
  EXPECT_TRUE(message().contains("there_is_no_folder"));
  ASSERT_TRUE(panel->adopt(folder.filePath("anna.vtp")));
  EXPECT_EQ(window->model().state().curvesFile, folder.filePath("anna.vtp").toStdString());
  ASSERT_TRUE(waitUntil([&] { return rms() < 0.7; }, longest)) << report().toStdString();
  EXPECT_GT(before, 2.0 * rms());
  EXPECT_TRUE(report().contains("Curves measured from subject01_neutral.ply, which are the shown face:"))
      << report().toStdString();
  find<QComboBox>("scanDistances")->setCurrentIndex(2);
  ASSERT_TRUE(waitUntil([&] { return report().startsWith("Scan to shown face"); }, longest));
  find<QComboBox>("scanDistances")->setCurrentIndex(0);
  EXPECT_TRUE(waitUntil([&] {
    return !report().contains("shown face to scan", Qt::CaseInsensitive) && !report().contains("Scan to shown");
  }));
}

/// Told by the curves: a session knows no more than the file that is the face.
TEST_F(ScanPanel, AfterTheSessionIsReopenedTheCurvesAreStillTheShownFace) {
  QTemporaryDir folder;
  const QString session = folder.filePath("anna.mien-session.json"), scan = folder.filePath("anna.obj");
  writeScan(DenseFace(110, 111), scan);
  panel->open(scan);
  ASSERT_TRUE(waitUntil([&] { return panel->hasScan(); }, longest));
  ASSERT_TRUE(panel->adopt(folder.filePath("anna.vtp")));
  ASSERT_TRUE(window->document().save(session));
  window = std::make_unique<mien::StudioWindow>();
  window->show();
  panel = find<mien::ScanPanel>("scanPanel");
  ASSERT_TRUE(window->document().open(session)) << message().toStdString();
  ASSERT_TRUE(waitUntil([&] { return panel->hasScan(); }, longest));
  EXPECT_TRUE(report().contains("anna.obj, which are the shown face:")) << report().toStdString();
  window->model().openCurves(QString());
  EXPECT_TRUE(report().contains("anna.obj, not adopted yet:")) << report().toStdString();
}

/// The dock scrolls, and nothing in it.
TEST_F(ScanPanel, TheReportIsAsHighAsItsText) {
  auto* text = find<QPlainTextEdit>("scanReport");
  find<QTabWidget>("curveTabs")->setCurrentIndex(1);
  settle();
  const int before = text->minimumHeight();
  const QString line("one line that is read whole");
  text->setPlainText(QStringList(QVector<QString>(40, line).toList()).join('\n'));
  settle();
  EXPECT_GE(text->height(), 40 * text->fontMetrics().lineSpacing());
  EXPECT_GT(text->height(), before);
  EXPECT_FALSE(text->verticalScrollBar()->isVisible());
  EXPECT_EQ(text->verticalScrollBar()->maximum(), 0) << "nothing is above or below what is seen";
  int scrolling = 0;
  for (const QWidget* parent = text->parentWidget(); parent; parent = parent->parentWidget())
    if (const auto* area = qobject_cast<const QAbstractScrollArea*>(parent))
      scrolling += area->verticalScrollBar()->isVisible();
  EXPECT_EQ(scrolling, 1);
  find<QTabWidget>("curveTabs")->setCurrentIndex(0);
  settle();
  EXPECT_FALSE(find<QScrollArea>("curvesDockScroll")->verticalScrollBar()->isVisible())
      << "a long report makes the other page no longer";
}

/// Each line, with the distances above them, in windows of the usual sizes; and the key says which skin is which.
TEST_F(ScanPanel, TheReportOfAScanIsSeenWhole) {
  MIEN_REQUIRE_REFERENCE("heads/subject01_neutral.ply");
  find<QAction>("actionWorkspace4")->trigger();
  auto* key = find<mien::ViewArea>("viewArea")->coloring()->key();
  EXPECT_FALSE(key->isVisible());
  EXPECT_FALSE(key->isOfScan());
  openSubject();
  ASSERT_TRUE(waitUntil([&] { return panel->hasScan(); }, longest));
  EXPECT_TRUE(key->isVisible());
  EXPECT_TRUE(key->isOfScan());
  for (int subject : {0, 1}) {
    find<QComboBox>("scanDistances")->setCurrentIndex(subject);
    ASSERT_TRUE(waitUntil([&] { return report().startsWith("Shown face to scan") == (subject == 1); }, longest));
    EXPECT_EQ(key->isOfScan(), subject == 0) << "the scan is hidden where colours have a meaning";
    for (const QSize& size : {QSize(1000, 700), QSize(1280, 800), QSize(2560, 1440)}) {
      window->resize(size);
      find<QAction>("actionResetWorkspace")->trigger();
      settle();
      EXPECT_FALSE(find<QScrollArea>("curvesDockScroll")->verticalScrollBar()->isVisible())
          << size.width() << " " << subject;
    }
  }
}

/// Over the background the scan is translucent, and so it is in its key.
TEST_F(ScanPanel, TheKeyOfAScanHasTheColourThatIsSeen) {
  MIEN_REQUIRE_REFERENCE("heads/subject01_neutral.ply");
  openSubject();
  ASSERT_TRUE(waitUntil([&] { return panel->hasScan(); }, longest));
  settle();
  const QImage key = find<mien::ViewArea>("viewArea")->coloring()->key()->grab().toImage();
  const QImage view = find<mien::FaceView>("faceView")->grab().toImage();
  QColor swatch;
  for (int x = 0; x < key.width() && !swatch.isValid(); ++x) {
    const QColor color = key.pixelColor(x, key.height() / 2);
    if (color.blue() > color.red() + 30) swatch = key.pixelColor(x + 4, key.height() / 2);  // within its edge
  }
  ASSERT_TRUE(swatch.isValid());
  int alike = 0;
  for (int y = 0; y < view.height(); ++y)
    for (int x = 0; x < view.width(); ++x) {
      const QColor seen = view.pixelColor(x, y);
      alike += std::max({std::abs(seen.red() - swatch.red()), std::abs(seen.green() - swatch.green()),
                         std::abs(seen.blue() - swatch.blue())}) <= 12;
    }
  EXPECT_GT(alike, 1000);
}

/// Mirrored, on a floor that is larger than the head.
TEST_F(ScanPanel, WhatIsDoubtfulAboutAScanIsToldInWordsAndSeenWhole) {
  DenseFace scan(110, 111);
  scan.mesh.vertices.col(0) *= -1.0;
  QTemporaryDir folder;
  const QString name = folder.filePath("mirrored.obj");
  writeScan(scan, name, "v -600 -180 -600\nv 600 -180 -600\nv 600 -180 600\nv -600 -180 600\nf -4 -1 -2\nf -4 -2 -3\n");
  find<QAction>("actionWorkspace4")->trigger();
  panel->open(name);
  ASSERT_TRUE(waitUntil([&] { return panel->hasScan(); }, longest)) << message().toStdString();
  EXPECT_TRUE(report().contains("\u00b0; its faces wind inwards: it may be mirrored\n")) << report().toStdString();
  EXPECT_TRUE(report().contains("RMS off; on part 2 of 2, larger ones left out\n")) << report().toStdString();
  for (int subject : {0, 1}) {
    find<QComboBox>("scanDistances")->setCurrentIndex(subject);
    ASSERT_TRUE(waitUntil([&] { return report().startsWith("Shown face to scan") == (subject == 1); }, longest));
    for (const QSize& size : {QSize(1000, 700), QSize(1280, 800)}) {
      window->resize(size);
      find<QAction>("actionResetWorkspace")->trigger();
      settle();
      EXPECT_FALSE(find<QScrollArea>("curvesDockScroll")->verticalScrollBar()->isVisible())
          << size.width() << " " << subject;
    }
  }
}

TEST_F(ScanPanel, TheButtonSaysThatItAsksForAFile) {
  auto* adopt = find<QToolButton>("scanAdopt");
  EXPECT_TRUE(adopt->text().startsWith("Save and adopt")) << adopt->text().toStdString();
  EXPECT_TRUE(adopt->toolTip().contains("Asks where")) << adopt->toolTip().toStdString();
}

/// In every workspace it is told, taken away and closed; the camera steps back for it once.
TEST_F(ScanPanel, AScanOverTheFaceIsFramedSwitchedAndClosed) {
  MIEN_REQUIRE_REFERENCE("heads/subject01_neutral.ply");
  auto* view = find<mien::FaceView>("faceView");
  auto* shown = find<QToolButton>("faceScan");
  auto* end = find<QAction>("actionCloseScan");
  const double alone = view->camera()->GetDistance();
  EXPECT_FALSE(shown->isVisible());
  EXPECT_FALSE(end->isEnabled());
  openSubject();
  ASSERT_TRUE(waitUntil([&] { return panel->hasScan(); }, longest));
  const double framed = view->camera()->GetDistance();
  EXPECT_GT(framed, alone);
  EXPECT_TRUE(end->isEnabled());
  find<QAction>("actionWorkspace1")->trigger();
  settle();
  EXPECT_TRUE(shown->isVisible());
  const int actors = view->renderer()->GetActors()->GetNumberOfItems();
  QTest::mouseClick(shown, Qt::LeftButton);
  EXPECT_EQ(view->renderer()->GetActors()->GetNumberOfItems(), actors - 1);
  EXPECT_FALSE(find<QCheckBox>("scanVisible")->isChecked());
  EXPECT_EQ(view->camera()->GetDistance(), framed) << "a switch moves no camera";
  find<QCheckBox>("scanVisible")->setChecked(true);
  EXPECT_TRUE(shown->isChecked());
  view->placeCamera({0, 0, 0}, {0, 0, 1}, 500.0);
  emit find<QComboBox>("scanUnit")->activated(0);
  ASSERT_TRUE(waitUntil([&] { return !panel->isMeasuring(); }, longest));
  EXPECT_EQ(view->camera()->GetDistance(), 500.0) << "measured again, it leaves the user's camera alone";
  end->trigger();
  settle();
  EXPECT_FALSE(panel->hasScan());
  EXPECT_FALSE(shown->isVisible());
  EXPECT_FALSE(end->isEnabled());
  EXPECT_EQ(view->renderer()->GetActors()->GetNumberOfItems(), actors - 1);
  EXPECT_NEAR(view->camera()->GetDistance(), alone, 1e-9 * alone);
}

/// Seen through a scan, no colour would be that of its scale.
TEST_F(ScanPanel, AScanGivesWayToColoursThatHaveAMeaning) {
  MIEN_REQUIRE_REFERENCE("heads/subject01_neutral.ply");
  openSubject();
  ASSERT_TRUE(waitUntil([&] { return panel->hasScan(); }, longest));
  auto* view = find<mien::FaceView>("faceView");
  auto* shown = find<QToolButton>("faceScan");
  const auto actors = [&] { return view->renderer()->GetActors()->GetNumberOfItems(); };
  const int both = actors();
  const double framed = view->camera()->GetDistance();
  find<QComboBox>("colorBy")->setCurrentText("Mean curvature H (1/mm)");
  settle();
  EXPECT_EQ(actors(), both - 1);
  EXPECT_LT(view->camera()->GetDistance(), framed) << "the camera does not keep room for what is hidden";
  EXPECT_FALSE(shown->isEnabled());
  EXPECT_FALSE(find<QCheckBox>("scanVisible")->isEnabled());
  EXPECT_TRUE(shown->toolTip().contains("tint")) << shown->toolTip().toStdString();
  find<QComboBox>("colorBy")->setCurrentText("Skin");
  settle();
  EXPECT_EQ(actors(), both);
  EXPECT_TRUE(shown->isEnabled());
  EXPECT_NEAR(view->camera()->GetDistance(), framed, 1e-9 * framed);
  find<QComboBox>("scanDistances")->setCurrentIndex(1);
  ASSERT_TRUE(waitUntil([&] { return report().startsWith("Shown face to scan"); }, longest));
  EXPECT_FALSE(shown->isEnabled());
  EXPECT_LT(view->camera()->GetDistance(), framed);
}

/// A leads, with all that it shows; where both headers have one row, the views are of one size.
TEST_F(ScanPanel, WithAScanBothFacesOfAComparisonAreOfOneScale) {
  MIEN_REQUIRE_REFERENCE("heads/subject01_neutral.ply");
  openSubject();
  ASSERT_TRUE(waitUntil([&] { return panel->hasScan(); }, longest));
  window->resize(1600, 900);
  emit find<QComboBox>("compareWith")->activated(1);
  settle();
  const auto scale = [&](const char* name) {
    auto* view = find<mien::FaceView>(name);
    return view->camera()->GetDistance() / view->height();  // as the angle of view is one
  };
  for (const char* coloring : {"Difference A\u2013B (mm)", "Skin"}) {
    find<QComboBox>("colorBy")->setCurrentText(coloring);
    settle();
    EXPECT_NEAR(scale("otherFaceView"), scale("faceView"), 0.01 * scale("faceView")) << coloring;
    window->resize(1640, 950);
    settle();
    EXPECT_NEAR(scale("otherFaceView"), scale("faceView"), 0.01 * scale("faceView")) << coloring << ", resized";
  }
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
