#include <QAction>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QToolButton>

#include "CoefficientTable.h"
#include "DefaultRegions.h"
#include "FaceModel.h"
#include "StudioFixture.h"

namespace {

/// The dock before anything moves the face, and right after that.
class DeformationAtRest : public StudioFixture {
 protected:
  DeformationAtRest() {
    find<QAction>("deformationDockAction")->trigger();
    cells = find<mien::CoefficientTable>("deformationCoefficients");
    EXPECT_TRUE(waitUntil([this] { return !cells->text().empty(); }));
  }

  void choose(const QString& name) {
    find<QComboBox>("deformationTable")->setCurrentText(name);
    settle();
  }

  bool waitForNumbers() {
    return waitUntil([this] { return cells->isVisible(); });
  }

  mien::CoefficientTable* cells;
};

/// At rest there are no numbers to read, but examples, and one click shows what the dock is for.
TEST_F(DeformationAtRest, TheFaceAtRestOffersExamples) {
  EXPECT_FALSE(cells->isVisible());
  ASSERT_TRUE(find<QWidget>("deformationEmpty")->isVisible());
  QTest::mouseClick(find<QToolButton>("deformationExample_joy"), Qt::LeftButton);
  EXPECT_EQ(window->model().state().deformation.table, "joy");
  EXPECT_EQ(window->model().state().deformation.strength, 1.0);
  ASSERT_TRUE(waitForNumbers());
  EXPECT_TRUE(find<QLabel>("deformationExpression")->text().startsWith("Nearest: joy, "));
  EXPECT_TRUE(find<QLabel>("deformationExpression")->text().endsWith(" %"));
  EXPECT_FALSE(find<QWidget>("deformationEmpty")->isVisible());
  choose("None");
  EXPECT_TRUE(waitUntil([&] { return !cells->isVisible(); }));
}

/// Until the first fit is there the dock does not say that nothing moves.
TEST_F(DeformationAtRest, AFaceThatBeginsToMoveIsBeingFitted) {
  window->model().change([](mien::FaceState& state) { state.expressions["surprise"] = 1.0; });
  EXPECT_TRUE(find<QWidget>("deformationFitting")->isVisible());
  EXPECT_FALSE(find<QWidget>("deformationEmpty")->isVisible());
  ASSERT_TRUE(waitForNumbers());
  window->model().change([](mien::FaceState& state) { state.expressions.clear(); });
  EXPECT_TRUE(waitUntil([this] { return find<QWidget>("deformationEmpty")->isVisible(); }));
}

/// Names of the regions, units of the numbers, and no column out of sight in a window of the usual size.
TEST_F(DeformationAtRest, TheTableSaysWhereAndInWhichUnit) {
  choose("Joy");
  ASSERT_TRUE(waitForNumbers());
  for (int region = 1; region <= 16; ++region) {
    const QString name = QString::fromStdString(mien::defaultRegions().name(region));
    const QString header = cells->verticalHeaderItem(region - 1)->text();
    EXPECT_TRUE(header.startsWith(QString::number(region) + ' ' + name.section(' ', 0, 0))) << header.toStdString();
    EXPECT_TRUE(cells->verticalHeaderItem(region - 1)->toolTip().endsWith(name));
  }
  EXPECT_EQ(cells->horizontalHeaderItem(0)->text().toStdString(), "a1\n1/pu");
  EXPECT_EQ(cells->horizontalHeaderItem(11)->text().toStdString(), "b6\npu");
  for (const QSize& size : {QSize(1280, 800), QSize(1000, 700)}) {
    window->resize(size);
    settle();
    find<QAction>("actionWorkspace3")->trigger();
    find<QAction>("actionResetWorkspace")->trigger();
    settle();
    EXPECT_FALSE(cells->horizontalScrollBar()->isVisible()) << size.width();
    EXPECT_GT(find<QWidget>("deformationFigure")->width(), 150) << size.width();
  }
}

}  // namespace
