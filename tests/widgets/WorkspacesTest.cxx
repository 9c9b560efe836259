#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QTabBar>
#include <QTemporaryDir>
#include <QToolButton>
#include <algorithm>

#include "ColorScale.h"
#include "DockScroll.h"
#include "ExpressionRow.h"
#include "FAPRow.h"
#include "OverflowRow.h"
#include "SessionDocument.h"
#include "StudioFixture.h"
#include "Workspaces.h"

namespace {

class Workspaces : public StudioFixture {
 protected:
  QStringList shown() {
    QStringList names;
    for (const auto* dock : window->findChildren<QDockWidget*>())
      if (!dock->isHidden()) names << dock->objectName();
    names.sort();
    return names;
  }

  void choose(int workspace) {
    find<QAction>(QString("actionWorkspace%1").arg(workspace))->trigger();
    settle();
  }

  QDockWidget* dock(const char* name) { return find<QDockWidget>(name); }

  /// What a widget must lie in to be reached: what scrolls, where something does, else the window.
  static const QWidget* roomOf(const QWidget* widget) {
    for (const QWidget* parent = widget->parentWidget(); parent; parent = parent->parentWidget()) {
      const auto* area =
          parent->parentWidget() ? qobject_cast<QScrollArea*>(parent->parentWidget()->parentWidget()) : nullptr;
      if (area && area->widget() == parent) return parent;
    }
    return widget->window();
  }

  const QSize smallest{960, 660};
};

TEST_F(Workspaces, EachOpensItsDocks) {
  const QStringList expected[] = {{"expressionDock", "fapDock", "surfaceDock"},
                                  {"continuityDock", "expressionDock", "smoothingDock", "spectrumDock", "surfaceDock"},
                                  {"deformationDock", "expressionDock", "fapDock", "vectorsDock"},
                                  {"curvesDock", "expressionDock", "surfaceDock", "textureDock"}};
  EXPECT_EQ(shown(), expected[0]);
  for (int i : {1, 2, 3, 0}) {
    choose(i + 1);
    EXPECT_EQ(shown(), expected[i]) << i;
    EXPECT_EQ(find<QTabBar>("workspaces")->currentIndex(), i);
  }
  find<QTabBar>("workspaces")->setCurrentIndex(1);
  settle();
  EXPECT_EQ(shown(), expected[1]);
  EXPECT_TRUE(find<QAction>("actionWorkspace2")->isChecked());
}

TEST_F(Workspaces, EachKeepsWhatTheUserMadeOfItUntilItIsReset) {
  choose(2);
  dock("smoothingDock")->close();
  window->addDockWidget(Qt::RightDockWidgetArea, dock("spectrumDock"));
  const QStringList own = shown();
  choose(4);
  EXPECT_NE(shown(), own);
  choose(2);
  EXPECT_EQ(shown(), own);
  EXPECT_EQ(window->dockWidgetArea(dock("spectrumDock")), Qt::RightDockWidgetArea);
  find<QAction>("actionResetWorkspace")->trigger();
  settle();
  EXPECT_EQ(window->dockWidgetArea(dock("spectrumDock")), Qt::BottomDockWidgetArea);
  EXPECT_FALSE(dock("smoothingDock")->isHidden());
}

/// What is beyond a window's edge cannot be used.
TEST_F(Workspaces, AllFitIntoASmallScreen) {
  for (int i = 1; i <= 4; ++i) {
    choose(i);
    EXPECT_LE(window->minimumSizeHint().width(), 1280) << i;
    EXPECT_LE(window->minimumSizeHint().height(), 800) << i;
    EXPECT_EQ(window->size(), QSize(1280, 800)) << i;
    EXPECT_GE(find<QWidget>("faceView")->height(), 200) << i;
  }
}

/// The smallest window of all: nothing is cut off that cannot be scrolled to, and the window does not grow.
TEST_F(Workspaces, AllCanBeUsedInTheSmallestWindow) {
  window->resize(smallest);
  settle();
  for (int i : {2, 3, 4, 1}) {
    choose(i);
    EXPECT_EQ(window->size(), smallest) << i;
    EXPECT_LE(window->minimumSizeHint().width(), smallest.width()) << i;
    EXPECT_LE(window->minimumSizeHint().height(), smallest.height()) << i;
    EXPECT_GE(find<QWidget>("faceView")->height(), 100) << i;
    for (const auto* widget : window->findChildren<QWidget*>()) {
      const bool isControl = qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QComboBox*>(widget) ||
                             qobject_cast<const QAbstractSpinBox*>(widget);
      const QString name = widget->objectName();
      if (!isControl || !widget->isVisible() || name.isEmpty() || name.startsWith("qt_")) continue;
      const QWidget* room = roomOf(widget);
      const QRect place(widget->mapTo(const_cast<QWidget*>(room), QPoint()), widget->size());
      EXPECT_TRUE(room->rect().contains(place)) << i << " " << name.toStdString();
    }
  }
}

/// One row above each view, whatever the width: what has no room waits in a panel, named and within reach.
TEST_F(Workspaces, NoButtonStandsInARowOfItsOwn) {
  for (const QSize& size : {QSize(960, 660), QSize(1000, 700), QSize(1280, 800)}) {
    window->resize(size);
    settle();
    for (const char* name : {"faceViewHeader", "curveViewHeader", "coloringBar", "curveKey"}) {
      auto* row = find<mien::OverflowRow>(name);
      int high = 0, waiting = 0;
      for (const auto* button : row->findChildren<QToolButton*>()) {
        if (button == row->more()) continue;
        high = std::max(high, button->sizeHint().height());
        waiting += row->isInPanel(button);
        if (button->isVisible()) {
          EXPECT_TRUE(row->rect().contains(button->geometry())) << name;
        }
      }
      EXPECT_LT(row->height(), 2 * high) << name << " at " << size.width();
      EXPECT_TRUE(!waiting || row->more()->isVisible()) << name << " at " << size.width();
    }
    EXPECT_EQ(find<mien::OverflowRow>("faceViewHeader")->more()->isVisible(), size.width() < 1280);
  }
}

TEST_F(Workspaces, WhatWaitsInAPanelWorksThereAndComesBack) {
  window->resize(smallest);
  settle();
  auto* row = find<mien::OverflowRow>("curveViewHeader");
  auto* link = find<QToolButton>("curveLink");
  ASSERT_TRUE(row->isInPanel(link));
  EXPECT_FALSE(link->isVisible());
  QTest::mouseClick(row->more(), Qt::LeftButton);
  ASSERT_TRUE(link->isVisible());
  EXPECT_TRUE(link->window() != window.get());
  QTest::mouseClick(link, Qt::LeftButton);
  EXPECT_FALSE(link->isChecked());
  link->window()->close();
  window->resize(1280, 800);
  settle();
  EXPECT_FALSE(row->isInPanel(link));
  EXPECT_TRUE(link->isVisible());
  EXPECT_FALSE(link->isChecked());
  EXPECT_EQ(find<QToolButton>("curveFrontOnly")->nextInFocusChain(), link) << "Tab goes from left to right again";
  EXPECT_LT(find<QToolButton>("curveFrontOnly")->x(), link->x());
}

/// Neither the window nor a dock of a small workspace scrolls sideways.
TEST_F(Workspaces, DocksBelowNeverScrollSideways) {
  for (const QSize& size : {QSize(1000, 700), smallest}) {
    window->resize(size);
    settle();
    for (int i : {2, 3, 4}) {
      choose(i);
      for (const char* name : {"spectrumDock", "smoothingDock", "continuityDock", "deformationDock", "vectorsDock",
                               "curvesDock", "textureDock"}) {
        if (!dock(name)->isVisible()) continue;
        dock(name)->raise();
        settle();
        const auto* area = find<mien::DockScroll>(QString(name) + "Scroll");
        EXPECT_FALSE(area->horizontalScrollBar()->isVisible())
            << i << " " << name << ": " << area->widget()->minimumSizeHint().width() << " of "
            << area->viewport()->width();
      }
    }
  }
}

/// Beside the FAPs as well, where a dock is opened from the menu.
TEST_F(Workspaces, ADockBesideTheOthersNeverScrollsSideways) {
  for (const QSize& size : {QSize(1000, 700), QSize(960, 700)}) {
    window->resize(size);
    settle();
    for (const char* name : {"smoothingDock", "continuityDock"}) {
      dock(name)->toggleViewAction()->trigger();
      settle();
      EXPECT_TRUE(dock(name)->isVisible());
      EXPECT_FALSE(find<mien::DockScroll>(QString(name) + "Scroll")->horizontalScrollBar()->isVisible())
          << name << " at " << size.width();
      dock(name)->toggleViewAction()->trigger();
    }
  }
}

/// Where a column of rows scrolls, the last that is seen is whole.
TEST_F(Workspaces, NoRowOfAColumnIsCutThrough) {
  for (const QSize& size : {QSize(1000, 700), QSize(1000, 660), QSize(1280, 720)}) {
    window->resize(size);
    settle();
    for (int i : {1, 3}) {
      choose(i);
      settle();
      for (const auto* row : window->findChildren<mien::FAPRow*>()) {
        if (!row->visibleRegion().isEmpty()) {
          EXPECT_EQ(row->visibleRegion().boundingRect().height(), row->height()) << i << " " << size.height();
        }
      }
      for (const auto* row : window->findChildren<mien::ExpressionRow*>())
        if (!row->visibleRegion().isEmpty()) {
          EXPECT_EQ(row->visibleRegion().boundingRect().height(), row->height()) << i << " " << size.height();
        }
    }
  }
}

/// A high window lists all FAPs rather than nothing, until the user has chosen.
TEST_F(Workspaces, AHighWindowHasNoHoleAtTheLeft) {
  const auto* all = find<QToolButton>("fapAll");
  EXPECT_FALSE(all->isChecked());
  window->resize(2560, 1440);
  settle();
  EXPECT_TRUE(all->isChecked());
  int bottom = 0;
  for (const auto* row : window->findChildren<mien::FAPRow*>())
    if (!row->visibleRegion().isEmpty())
      bottom = std::max(bottom, row->mapTo(window.get(), QPoint(0, row->height())).y());
  const auto* lock = find<QWidget>("fapMirror");
  EXPECT_LT(lock->mapTo(window.get(), QPoint()).y() - bottom, 60);
  window->resize(1280, 800);
  settle();
  EXPECT_FALSE(all->isChecked());
  find<QToolButton>("fapAll")->click();
  window->resize(1280, 820);
  settle();
  EXPECT_TRUE(all->isChecked()) << "it is the user's from then on";
  find<QToolButton>("fapAll")->click();
}

/// Of the scale of the curves, whatever it ends with.
TEST_F(Workspaces, NumbersOfTheScaleKeepApart) {
  window->resize(smallest);
  settle();
  auto* scale = find<mien::ColorScale>("curveScale");
  EXPECT_GE(scale->width(), scale->minimumSizeHint().width());
  for (double width : {20.0, 40.0, 60.0, 200.0}) {
    for (double end : {2.0, 0.25, 7.5, 125.0}) {
      find<QDoubleSpinBox>("curveRange")->setValue(end);
      const std::vector<QRectF> places = scale->numberPlaces({100.0, 5.0, width, 9.0});
      for (size_t i = 2; i < places.size(); ++i)
        for (size_t other = 0; other < i; ++other)
          EXPECT_FALSE(places[i].intersects(places[other])) << width << " pixels, " << end << " mm";
    }
  }
  find<QDoubleSpinBox>("curveRange")->setValue(2.0);
  EXPECT_EQ(scale->numberPlaces({100.0, 5.0, 200.0, 9.0}).size(), 3u);
  EXPECT_EQ(scale->numberPlaces({100.0, 5.0, 20.0, 9.0}).size(), 2u);
}

TEST_F(Workspaces, ALargeWindowHasDocksBesideEachOtherAndTheFAPs) {
  window->resize(2560, 1440);
  settle();
  for (int i : {2, 3, 4}) {
    choose(i);
    EXPECT_TRUE(dock("fapDock")->isVisible()) << i;
    EXPECT_EQ(window->size(), QSize(2560, 1440)) << i;
    EXPECT_GE(dock("expressionDock")->widget()->height(), dock("expressionDock")->widget()->sizeHint().height()) << i;
  }
  const std::pair<const char*, const char*> pairs[] = {
      {"spectrumDock", "smoothingDock"}, {"deformationDock", "vectorsDock"}, {"curvesDock", "textureDock"}};
  for (int i : {2, 3, 4}) {
    choose(i);
    const auto [left, right] = pairs[i - 2];
    EXPECT_FALSE(dock(left)->visibleRegion().isEmpty()) << left;
    EXPECT_FALSE(dock(right)->visibleRegion().isEmpty()) << right;
    EXPECT_NEAR(dock(left)->width(), dock(right)->width(), 20);
  }
}

/// Whatever sizes the window has had.
TEST_F(Workspaces, DocksOfAFixedHeightLeaveNoHoles) {
  for (const QSize& size : {QSize(1900, 1150), QSize(1280, 800), QSize(1280, 1100), QSize(1600, 900)}) {
    window->resize(size);
    settle();
    for (int i : {1, 2, 3, 4}) {
      choose(i);
      settle();
      int bottom = 0;
      for (const char* name : {"surfaceDock", "expressionDock", "fapDock"})
        if (dock(name)->isVisible()) bottom = std::max(bottom, dock(name)->geometry().bottom());
      for (const char* name : {"surfaceDock", "expressionDock"}) {
        const bool takesTheRest = dock(name)->geometry().bottom() == bottom && !dock("fapDock")->isVisible();
        if (dock(name)->isVisible() && !takesTheRest) {
          EXPECT_LE(dock(name)->height(), dock(name)->sizeHint().height() + 2)
              << name << " in " << i << " at " << size.width() << " x " << size.height();
        }
      }
    }
  }
}

TEST_F(Workspaces, AllComeBackAtTheNextStart) {
  QTemporaryDir folder;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder.path());
  QCoreApplication::setOrganizationName("mien-test");
  {
    mien::StudioWindow first;
    first.show();
    first.findChild<QAction*>("actionWorkspace2")->trigger();
    first.findChild<QDockWidget*>("smoothingDock")->close();
    first.findChild<QAction*>("actionWorkspace3")->trigger();
    first.close();
  }
  mien::StudioWindow second;
  second.show();
  const auto isHidden = [&](const char* name) { return second.findChild<QDockWidget*>(name)->isHidden(); };
  EXPECT_EQ(second.findChild<QTabBar*>("workspaces")->currentIndex(), 2);
  EXPECT_FALSE(isHidden("deformationDock"));
  second.findChild<QAction*>("actionWorkspace2")->trigger();
  EXPECT_TRUE(isHidden("smoothingDock"));
  EXPECT_FALSE(isHidden("spectrumDock"));
  QCoreApplication::setOrganizationName(QString());
}

TEST_F(Workspaces, ASessionKnowsWhichOneItWasMadeIn) {
  QTemporaryDir folder;
  const QString file = folder.filePath("deform.mien-session.json");
  choose(3);
  dock("vectorsDock")->close();
  const QStringList own = shown();
  ASSERT_TRUE(window->document().save(file));
  choose(1);
  ASSERT_TRUE(window->document().open(file));
  settle();
  EXPECT_EQ(find<QTabBar>("workspaces")->currentIndex(), 2);
  EXPECT_EQ(shown(), own);
}

}  // namespace
