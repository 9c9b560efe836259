#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QFile>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QSettings>
#include <QTabWidget>
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
      {"fapHeading8", "fapDock"}, {"timelineTitle", "timelinePanel"}, {"surfaceRemainder", "surfaceDock"}};
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
    EXPECT_TRUE(version.contains(QRegularExpression("\\d"))) << library.toStdString() << " " << version.toStdString();
  }
  find<QAction>("actionAbout")->trigger();
  auto* dialog = find<mien::AboutDialog>("aboutDialog");
  auto* pages = dialog->findChild<QTabWidget*>("aboutPages");
  for (int page = 0; page < pages->count(); ++page) {
    pages->setCurrentIndex(page);
    int seen = 0;
    for (const char* copy : {"aboutCopyVersions", "aboutCopyCitations", "aboutCopyLicence"})
      seen += dialog->findChild<QPushButton*>(copy)->isVisible();
    EXPECT_EQ(seen, 1) << page;
  }
  dialog->findChild<QPushButton*>("aboutCopyCitations")->click();
  EXPECT_EQ(QGuiApplication::clipboard()->text().toStdString(), mien::Citations());
  dialog->close();
}

/// Under the names that README's table of dependencies has for them; what is only needed to build, test or draw without
/// a display is not part of the programs.
TEST_F(HelpMenu, AboutNamesEveryLibraryOfTheReadme) {
  QFile file(MIEN_TEST_DIR "/../README.md");
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QString readme = QString::fromUtf8(file.readAll());
  const QString table = readme.section("| what for |", 1).section("| Python ", 0, 0);
  QStringList known;
  for (const auto& [library, version] : mien::libraryVersions()) known << library.toLower();
  int count = 0;
  for (const QString& line : table.split('\n')) {
    const QString names = line.section('|', 1, 1).trimmed();
    if (names.isEmpty() || names.startsWith("---") || names.startsWith("C++17")) continue;
    for (const QString& name : names.split(", ")) {
      EXPECT_TRUE(known.contains(name.section(' ', 0, 0).toLower())) << name.toStdString();
      ++count;
    }
  }
  EXPECT_GE(count, 9);
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

/// What is spoken of is seen, whatever the size of the window.
TEST_F(HelpMenu, TheTourSpeaksOfEveryPartBesideIt) {
  for (const QSize& size : {QSize(1280, 800), QSize(1000, 700), QSize(960, 660), QSize(1900, 1150)}) {
    window->resize(size);
    settle();
    mien::Tour* tour = mien::Tour::begin(*window);
    ASSERT_EQ(tour->stopCount(), 6);
    for (int i = 0; i < tour->stopCount(); ++i) {
      EXPECT_EQ(tour->current(), i) << size.width();
      EXPECT_FALSE(tour->targetOf(i).isEmpty()) << i;
      EXPECT_TRUE(tour->rect().contains(tour->calloutOf(i))) << i;
      EXPECT_FALSE(tour->calloutOf(i).intersects(tour->targetOf(i))) << i << " at " << size.width();
      if (i + 1 < tour->stopCount()) QTest::keyClick(tour, Qt::Key_Space);
    }
    QTest::keyClick(tour, Qt::Key_Left);
    EXPECT_EQ(tour->current(), tour->stopCount() - 2);
    QTest::keyClick(tour, Qt::Key_Escape);
    EXPECT_FALSE(shownTour());
  }
  find<QAction>("actionTour")->trigger();
  const int stops = static_cast<mien::Tour*>(shownTour())->stopCount();
  for (int i = 0; i < stops; ++i) {
    ASSERT_TRUE(shownTour()) << i;
    QTest::mouseClick(shownTour(), Qt::LeftButton);
  }
  settle();
  EXPECT_FALSE(shownTour());
}

/// The part that is spoken of is as bright as without the tour, the rest is not.
TEST_F(HelpMenu, TheTourLeavesWhatItSpeaksOfFree) {
  const auto brightness = [this](const char* name) {
    auto* widget = find<QWidget>(name);
    const QImage image = window->grab(QRect(widget->mapTo(window.get(), QPoint(6, 6)), QSize(60, 20))).toImage();
    return qGray(image.pixel(image.width() / 2, 2));
  };
  const int free = brightness("expressionDock"), other = brightness("surfaceDock");
  mien::Tour* tour = mien::Tour::begin(*window);
  ASSERT_EQ(tour->current(), 0);
  EXPECT_EQ(brightness("expressionDock"), free);
  EXPECT_LT(brightness("surfaceDock"), 0.6 * other);
}

TEST_F(HelpMenu, TheTourComesOnceForAUserAndNeverToATest) {
  mien::Tour::showAtFirstStart(*window);
  settle();
  EXPECT_FALSE(shownTour());
  QTemporaryDir folder;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder.path());
  QCoreApplication::setOrganizationName("mien-test");
  mien::Tour::showAtFirstStart(*window);
  EXPECT_TRUE(QTest::qWaitFor([this] { return shownTour(); }, 20000));
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
  QTest::keyClick(shownTour(), Qt::Key_Escape);
  QTest::qWait(500);
  window->history().record();
  EXPECT_EQ(window->history().count(), 0) << window->history().undoText().toStdString();
  EXPECT_FALSE(window->document().isModified());
}

}  // namespace
