#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QFile>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QSettings>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTextBrowser>

#include "AboutDialog.h"
#include "Citations.h"
#include "History.h"
#include "LibraryVersions.h"
#include "ManualPage.h"
#include "ManualWindow.h"
#include "SessionDocument.h"
#include "ShortcutList.h"
#include "StudioFixture.h"
#include "Tour.h"

namespace {

class HelpMenu : public StudioFixture {
 protected:
  /// One that is closed goes as soon as events are looked at.
  QWidget* shownTour() {
    for (auto* tour : window->findChildren<QWidget*>("tour"))
      if (tour->isVisible()) return tour;
    return nullptr;
  }
};

QStringList sections() {
  QStringList names;
  static const QRegularExpression anchor("<h2><a name=\"([^\"]+)\">");
  auto found = anchor.globalMatch(QString::fromStdString(mien::ManualPage()));
  while (found.hasNext()) names << found.next().captured(1);
  return names;
}

TEST_F(HelpMenu, TheManualHasASectionForEveryDock) {
  for (const auto* dock : window->findChildren<QDockWidget*>())
    EXPECT_TRUE(sections().contains(dock->objectName())) << dock->objectName().toStdString();
  QStringList once = sections();
  EXPECT_EQ(once.removeDuplicates(), 0);
}

TEST_F(HelpMenu, TheManualNeedsNoNetwork) {
  const QString page = QString::fromStdString(mien::ManualPage());
  for (const char* part : {"http", "<img", "<script", "<link"}) EXPECT_FALSE(page.contains(part)) << part;
}

TEST_F(HelpMenu, TheManualOpensAtTheDockThatHasTheFocus) {
  const std::pair<const char*, const char*> places[] = {
      {"surfaceModes", "surfaceDock"}, {"fapSearch", "fapDock"},           {"timelineFrame", "timelinePanel"},
      {"faceMesh", "viewArea"},        {"spectrumFigure", "spectrumDock"}, {"workspaces", "workspaces"}};
  find<QAction>("actionManual")->trigger();
  auto* manual = find<mien::ManualWindow>("manualWindow");
  for (const auto& [widget, section] : places) {
    EXPECT_EQ(manual->sectionOf(find<QWidget>(widget)).toStdString(), section);
    manual->showSection(section);
    EXPECT_EQ(manual->section().toStdString(), section);
  }
  EXPECT_EQ(manual->sectionOf(nullptr), "start");
  QApplication::setActiveWindow(window.get());
  find<QWidget>("surfaceModes")->setFocus();
  ASSERT_TRUE(waitUntil([this] { return find<QWidget>("surfaceModes")->hasFocus(); }));
  find<QAction>("actionManual")->trigger();
  EXPECT_EQ(manual->section(), "surfaceDock");
}

TEST_F(HelpMenu, TheManualOpensAtTheDockThatWasClickedIn) {
  const std::pair<const char*, const char*> places[] = {
      {"fapHeading8", "fapDock"}, {"timelineTime", "timelinePanel"}, {"surfaceRemainder", "surfaceDock"}};
  for (const auto& [widget, section] : places) {
    QTest::mouseClick(find<QWidget>(widget), Qt::LeftButton);
    find<QAction>("actionManual")->trigger();
    EXPECT_EQ(find<mien::ManualWindow>("manualWindow")->section().toStdString(), section);
  }
}

TEST_F(HelpMenu, TheManualIsSearched) {
  find<QAction>("actionManual")->trigger();
  auto* manual = find<mien::ManualWindow>("manualWindow");
  auto* search = manual->findChild<QLineEdit*>("manualSearch");
  auto* page = manual->findChild<QTextBrowser*>("manualPage");
  QTest::keyClicks(search, "lebesgue");
  EXPECT_EQ(page->textCursor().selectedText().toLower(), "lebesgue");
  search->clear();
  QTest::keyClicks(search, "pupil");
  const int first = page->textCursor().position();
  QTest::keyClick(search, Qt::Key_Return);
  EXPECT_GT(page->textCursor().position(), first);
  QTest::keyClick(search, Qt::Key_Return, Qt::ShiftModifier);
  EXPECT_LE(page->textCursor().position(), first);
  QTest::keyClick(page, Qt::Key_Escape);
  EXPECT_FALSE(manual->isVisible());
}

TEST_F(HelpMenu, ShortcutsAreThoseOfTheWindow) {
  const auto keysOf = [this](const QString& command) {
    QString keys;
    for (const mien::ShortcutEntry& entry : mien::shortcutsOf(*window))
      if (entry.command == command) keys = entry.keys;
    return keys;
  };
  EXPECT_EQ(keysOf("Manual"), "F1");
  EXPECT_EQ(keysOf("Front"), "Ctrl+1");
  EXPECT_EQ(keysOf("Mirror lock"), "Alt+M");
  auto* neutral = find<QAction>("actionNeutral");
  neutral->setShortcut(QKeySequence("Ctrl+9"));
  EXPECT_EQ(keysOf("Neutral face"), "Ctrl+9");
  find<QAction>("actionShortcuts")->trigger();
  auto* table = window->findChild<QTableWidget*>("shortcutTable");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->rowCount(), static_cast<int>(mien::shortcutsOf(*window).size()));
  window->findChild<QLineEdit*>("shortcutSearch")->setText("ctrl+9");
  int shown = 0;
  for (int row = 0; row < table->rowCount(); ++row) shown += !table->isRowHidden(row);
  EXPECT_EQ(shown, 1);
}

TEST_F(HelpMenu, AboutTellsVersionsAndHowToCite) {
  for (const auto& [library, version] : mien::libraryVersions()) {
    const bool known = version.contains(QRegularExpression("\\d")) || library == "Mien";
    EXPECT_TRUE(known) << library.toStdString() << " " << version.toStdString();
  }
  find<QAction>("actionAbout")->trigger();
  auto* dialog = find<mien::AboutDialog>("aboutDialog");
  dialog->findChild<QPushButton*>("aboutCopyCitations")->click();
  EXPECT_EQ(QGuiApplication::clipboard()->text().toStdString(), mien::Citations());
  dialog->close();
}

/// What CITATION.cff says of each work is in the BibTeX entry too, but for braces.
TEST_F(HelpMenu, BothFormsOfTheCitationAgree) {
  QFile file(MIEN_TEST_DIR "/../CITATION.cff");
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QString bib = QString::fromStdString(mien::Citations()).remove('{').remove('}');
  static const QRegularExpression value(
      "^ *-? *(title|volume|year|start|end|doi|license|family-names|journal): \"?([^\"\n]+)\"?$",
      QRegularExpression::MultilineOption);
  auto found = value.globalMatch(QString::fromUtf8(file.readAll()));
  int count = 0;
  for (; found.hasNext(); ++count) {
    const QString text = found.next().captured(2);
    EXPECT_TRUE(bib.contains(text, Qt::CaseInsensitive)) << text.toStdString();
  }
  EXPECT_GE(count, 20);
}

TEST_F(HelpMenu, TheTourSpeaksOfEveryPartWithoutOverlap) {
  for (const QSize& size : {QSize(1280, 800), QSize(1900, 1150)}) {
    window->resize(size);
    settle();
    mien::Tour* tour = mien::Tour::begin(*window);
    ASSERT_EQ(tour->stopCount(), 6);
    for (int i = 0; i < tour->stopCount(); ++i) {
      EXPECT_FALSE(tour->targetOf(i).isEmpty()) << i;
      EXPECT_TRUE(tour->rect().contains(tour->calloutOf(i))) << i;
      for (int other = 0; other < i; ++other)
        EXPECT_FALSE(tour->calloutOf(i).intersects(tour->calloutOf(other))) << i << " " << other;
    }
    QTest::keyClick(tour, Qt::Key_Escape);
    EXPECT_FALSE(shownTour());
  }
  find<QAction>("actionTour")->trigger();
  QTest::mouseClick(shownTour(), Qt::LeftButton);
  settle();
  EXPECT_FALSE(shownTour());
}

TEST_F(HelpMenu, TheTourComesOnceForAUserAndNeverToATest) {
  mien::Tour::showAtFirstStart(*window);
  settle();
  EXPECT_FALSE(shownTour());
  QTemporaryDir folder;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder.path());
  QCoreApplication::setOrganizationName("mien-test");
  mien::Tour::showAtFirstStart(*window);
  EXPECT_TRUE(QTest::qWaitFor([this] { return shownTour(); }));
  QTest::keyClick(shownTour(), Qt::Key_Escape);
  settle();
  mien::Tour::showAtFirstStart(*window);
  settle();
  EXPECT_FALSE(shownTour());
  QCoreApplication::setOrganizationName(QString());
}

TEST_F(HelpMenu, TheTourIsNoChange) {
  drawViews();
  mien::Tour::begin(*window);
  QTest::mouseClick(shownTour(), Qt::LeftButton);
  QTest::qWait(500);
  window->history().record();
  EXPECT_EQ(window->history().count(), 0) << window->history().undoText().toStdString();
  EXPECT_FALSE(window->document().isModified());
}

}  // namespace
