#include <QAbstractSpinBox>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QTabBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "FAPRow.h"
#include "RowScroll.h"
#include "StudioFixture.h"

namespace {

class RowScroll : public StudioFixture {
 protected:
  void choose(int workspace, const QSize& size) {
    window->resize(size);
    settle();
    find<QAction>(QString("actionWorkspace%1").arg(workspace))->trigger();
    find<QAction>("actionResetWorkspace")->trigger();
    rest();
  }

  void rest() {
    for (int i = 0; i < 3; ++i) settle();
    QTest::qWait(300);  // for docks that glide into their places
  }

  QRect placeOf(const QWidget* widget, const QWidget* in) const {
    return {widget->mapTo(const_cast<QWidget*>(in), QPoint()), widget->size()};
  }

  /// The part of the window that shows it: what has no place in a viewport on the way is not seen.
  bool isWhollySeen(const QWidget* widget) const {
    if (!widget->isVisible()) return false;
    for (const QWidget* parent = widget->parentWidget(); parent; parent = parent->parentWidget()) {
      if (!parent->rect().contains(placeOf(widget, parent))) return false;
      if (parent->isWindow()) break;
    }
    return true;
  }

  static bool hasRoom(const mien::RowScroll& scroll) {
    return scroll.widget()->minimumSizeHint().height() <= scroll.contentsRect().height();
  }

  void expectRowsBesideTheirBars(const std::string& when) {
    for (const auto* scroll : window->findChildren<mien::RowScroll*>()) {
      if (!scroll->isVisible()) continue;
      const QString name = scroll->objectName() + " in " + scroll->parentWidget()->objectName();
      const bool isFixed = scroll->horizontalScrollBarPolicy() == Qt::ScrollBarAlwaysOff;  // nothing scrolls sideways
      EXPECT_LE(scroll->widget()->width(),
                std::max(scroll->viewport()->width(), isFixed ? 0 : scroll->widget()->minimumSizeHint().width()))
          << name.toStdString() << " " << when << ": rows lie under the bar or are cut";
      const auto* layout = scroll->widget()->layout();
      if (hasRoom(*scroll) && !(layout && layout->hasHeightForWidth())) {
        EXPECT_FALSE(scroll->verticalScrollBar()->isVisible()) << name.toStdString() << " " << when;
      }
      EXPECT_GE(scroll->verticalScrollBar()->maximum() + scroll->viewport()->height(), scroll->widget()->height())
          << name.toStdString() << " " << when << ": what is below cannot be scrolled to";
    }
  }
};

TEST_F(RowScroll, RowsNeverLieUnderTheBarAndThereIsNoneWhereAllFit) {
  for (int workspace : {3, 2, 4, 1, 3}) {  // as they open for the first time
    find<QTabBar>("workspaces")->setCurrentIndex(workspace - 1);
    rest();
    expectRowsBesideTheirBars("first in " + std::to_string(workspace));
  }
  for (const QSize& size : {QSize(1280, 800), QSize(1000, 700), QSize(960, 660), QSize(1600, 1000), QSize(1280, 800)})
    for (int workspace : {3, 1, 2, 4, 3}) {
      choose(workspace, size);
      expectRowsBesideTheirBars(std::to_string(workspace) + " at " + std::to_string(size.width()));
    }
  find<QAction>("actionWorkspace1")->trigger();
  find<QAction>("actionWorkspace3")->trigger();
  rest();
  expectRowsBesideTheirBars("back");
  find<QToolButton>("fapAll")->click();
  rest();
  expectRowsBesideTheirBars("all FAPs");
}

TEST_F(RowScroll, AllFAPsAreWholeWhenTheyFirstCome) {
  window->resize(1280, 800);
  rest();
  find<QToolButton>("fapAll")->click();
  rest();
  expectRowsBesideTheirBars("all FAPs at once");
  const auto* list = find<mien::RowScroll>("fapList");
  for (const auto* row : list->widget()->findChildren<mien::FAPRow*>())
    EXPECT_LE(placeOf(row, list->viewport()).right(), list->viewport()->width()) << "FAP " << row->fap();
}

/// A page that gets longer and shorter, and a view that does.
TEST_F(RowScroll, TheBarComesAndGoesWithTheRows) {
  mien::RowScroll scroll;
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  std::vector<QLabel*> rows;
  for (int i = 0; i < 8; ++i) {
    rows.push_back(new QLabel(QString::number(i), page));
    rows.back()->setFixedHeight(30);
    column->addWidget(rows.back());
  }
  scroll.setWidget(page);
  scroll.resize(200, 400);
  scroll.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&scroll));
  const auto expectBar = [&](bool expected) {
    settle();
    EXPECT_EQ(scroll.verticalScrollBar()->isVisible(), expected) << scroll.height();
    EXPECT_EQ(page->width(), scroll.viewport()->width()) << scroll.height();
    const int last = scroll.viewport()->height();
    for (const QLabel* row : rows)
      EXPECT_FALSE(row->isVisible() && row->y() < last && row->geometry().bottom() >= last) << scroll.height();
  };
  for (int height = 400; height >= 100; height -= 7) {
    scroll.resize(200, height);
    expectBar(height < page->minimumSizeHint().height());
  }
  for (int i = 3; i < 8; ++i) rows[i]->hide();
  scroll.resize(200, 150);
  expectBar(false);
  for (int i = 3; i < 8; ++i) rows[i]->show();
  expectBar(true);
  scroll.resize(200, 400);
  expectBar(false);
}

/// What whole rows leave of the height is spread between them.
TEST_F(RowScroll, NoGapStaysBelowTheFAPs) {
  for (int height : {800, 780, 760, 830}) {
    choose(1, {1280, height});
    int bottom = 0, seen = 0;
    for (const auto* row : window->findChildren<mien::FAPRow*>()) {
      if (!isWhollySeen(row)) continue;
      ++seen;
      bottom = std::max(bottom, placeOf(row, window.get()).bottom());
    }
    const int lock = placeOf(find<QWidget>("fapMirror"), window.get()).top();
    if (seen < 3) continue;
    EXPECT_LT(lock - bottom, 30) << height << ": " << seen << " rows";
    if (height == 800) {
      EXPECT_EQ(seen, 5);
    }
  }
}

TEST_F(RowScroll, ControlsOfTheMotionVectorsAreInSight) {
  for (const QSize& size : {QSize(1280, 800), QSize(1000, 700)}) {
    choose(3, size);
    find<QDockWidget>("deformationDock")->toggleViewAction()->trigger();
    rest();
    for (const char* name : {"vectorsFit", "vectorsExport", "vectorsNumbers", "vectorsAgainst"})
      EXPECT_TRUE(isWhollySeen(find<QWidget>(name))) << name << " at " << size.width();
    const auto* side = find<mien::RowScroll>("vectorsSide");
    int seen = 0;
    for (const auto* control : side->widget()->findChildren<QWidget*>()) {
      if (!qobject_cast<const QComboBox*>(control) && !qobject_cast<const QCheckBox*>(control)) continue;
      const QRect place = placeOf(control, side->viewport());
      EXPECT_TRUE(place.top() >= side->viewport()->height() || place.bottom() < side->viewport()->height())
          << control->objectName().toStdString() << " is cut at " << size.width();
      seen += place.bottom() < side->viewport()->height();
    }
    EXPECT_GE(seen, 9) << size.width();
    find<QDockWidget>("deformationDock")->toggleViewAction()->trigger();
  }
}

/// Qt draws a line where a bar without tabs lies.
TEST_F(RowScroll, NoTabBarWithoutTabsLiesOverADock) {
  const auto expectNone = [this](const std::string& when) {
    rest();
    for (const auto* bar : window->findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly))
      EXPECT_FALSE(bar->isVisible() && bar->count() < 2 && bar->geometry().intersects(window->rect()))
          << when << ": " << bar->count() << " tabs at y " << bar->y();
  };
  for (const QSize& size : {QSize(1280, 800), QSize(1000, 700)})
    for (int workspace : {1, 3, 2, 4}) {
      choose(workspace, size);
      const std::string when = std::to_string(workspace) + " at " + std::to_string(size.width());
      expectNone(when);
      for (const char* name : {"expressionDock", "fapDock"}) {
        find<QDockWidget>(name)->toggleViewAction()->trigger();
        expectNone(when + " with " + name + " toggled");
      }
    }
}

}  // namespace
