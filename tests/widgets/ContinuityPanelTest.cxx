#include <vtkCamera.h>

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QHeaderView>
#include <QToolButton>

#include "CameraFlight.h"
#include "ContinuityTable.h"
#include "ExportButton.h"
#include "FaceModel.h"
#include "FigureView.h"
#include "StudioFixture.h"

namespace {

class ContinuityPanel : public StudioFixture {
 protected:
  ContinuityPanel() {
    window->model().change([](mien::FaceState& state) { state.surface.scheme = "four-curve"; });
    find<QAction>("continuityDockAction")->trigger();
    table = find<mien::ContinuityTable>("continuityTable");
    figure = find<mien::FigureView>("continuityFigure");
    EXPECT_TRUE(waitUntil([this] { return table->rowCount() == 9 && angle(8) > 10.0; }));
  }

  double angle(int row) const { return table->item(row, 3)->text().toDouble(); }  ///< largest G1, degrees

  std::array<double, 3> focus() {
    std::array<double, 3> point;
    find<mien::FaceView>("faceView")->camera()->GetFocalPoint(point.data());
    return point;
  }
  void land() {
    auto* flight = window->findChild<mien::CameraFlight*>();
    EXPECT_TRUE(waitUntil([&] { return flight->state() == QAbstractAnimation::Stopped; }));
  }
  QImage face() {
    settle();
    return find<QWidget>("faceView")->grab().toImage();
  }
  void clickRow(int row) {
    table->scrollToItem(table->item(row, 0));
    QTest::mouseClick(table->viewport(), Qt::LeftButton, Qt::NoModifier,
                      table->visualItemRect(table->item(row, 0)).center());
  }

  mien::ContinuityTable* table;
  mien::FigureView* figure;
};

TEST_F(ContinuityPanel, ListsTheSeamsAndFollowsTheScheme) {
  EXPECT_EQ(table->item(0, 0)->text(), "P0|P1");
  EXPECT_EQ(table->item(7, 0)->text(), "P7|P8");
  window->model().change([](mien::FaceState& state) { state.surface.scheme = "spline"; });
  EXPECT_TRUE(waitUntil([this] { return angle(8) < 1e-6; }));
}

/// What is rounding is told as such, in digits and on an axis of its own; every column has a unit.
TEST_F(ContinuityPanel, EveryHeadOfTheTableIsReadWhole) {
  auto* table = find<QTableWidget>("continuityTable");
  for (int rows : {0, 1}) {
    find<QComboBox>("continuityRows")->setCurrentIndex(rows);
    settle();
    for (int column = 1; column < table->columnCount(); ++column)
      for (const QString& line : table->horizontalHeaderItem(column)->text().split('\n'))
        EXPECT_GE(table->columnWidth(column), table->horizontalHeader()->fontMetrics().horizontalAdvance(line) + 8)
            << line.toStdString();
  }
}

TEST_F(ContinuityPanel, RoundingIsSeenAsRounding) {
  window->model().change([](mien::FaceState& state) { state.surface.scheme = "spline"; });
  ASSERT_TRUE(waitUntil([this] { return angle(8) < 1e-6; }));
  const double jump = table->item(8, 6)->text().toDouble();  // C2 over all seams
  EXPECT_GT(jump, 0.0);
  EXPECT_LT(jump, 1e-9);
  find<QComboBox>("continuityMeasure")->setCurrentText("C2 jump (relative)");
  const mien::Chart& panel = figure->figure().panels[0];
  EXPECT_EQ(panel.y.title, "P0|P1, C2 jump: rounding only");
  EXPECT_LE(*panel.y.end, 1e-9);
  for (int column = 1; column < table->columnCount(); ++column)
    EXPECT_FALSE(table->horizontalHeaderItem(column)->text().section('\n', 1).isEmpty()) << column;
}

/// The content decides the range: an angle of a few degrees is not at the bottom of half a turn.
TEST_F(ContinuityPanel, TheAxisOfAProfileFitsIt) {
  for (int row = 0; row < 8; ++row) {
    clickRow(row);
    const mien::Chart& panel = figure->figure().panels[0];
    double largest = 0.0;
    for (double value : panel.series[0].y) largest = std::max(largest, value);
    EXPECT_GE(*panel.y.end, largest) << row;
    EXPECT_LE(*panel.y.end, largest > 90.0 ? 180.0 : 1.7 * largest) << row;
  }
}

TEST_F(ContinuityPanel, FollowsASliderWhileItMoves) {
  const QString before = table->item(6, 3)->text();
  window->model().change([](mien::FaceState& state) { state.fapValues[53] = 300; });
  EXPECT_TRUE(waitUntil([&] { return table->item(6, 3)->text() != before; }));
}

TEST_F(ContinuityPanel, AClickedRowFliesToTheSeamAndShowsItsProfile) {
  clickRow(1);
  land();
  const double brow = focus()[1];
  EXPECT_NE(figure->figure().panels[0].y.title.find("P1|P2"), std::string::npos);
  QTest::keyClick(table, Qt::Key_Down);
  QTest::keyClick(table, Qt::Key_Down);
  EXPECT_NE(figure->figure().panels[0].y.title.find("P3|P4"), std::string::npos);
  land();
  EXPECT_LT(focus()[1], brow - 10.0);
  EXPECT_GT(colorsIn("faceView"), 200);
}

TEST_F(ContinuityPanel, TheRowOfTheProfileIsMarkedAndAnotherClickFliesBackToIt) {
  EXPECT_EQ(table->currentRow(), 0);
  EXPECT_NE(figure->figure().panels[0].y.title.find("P0|P1"), std::string::npos);
  const double wide = focus()[1];
  clickRow(0);
  land();
  const double near = focus()[1];
  EXPECT_GT(std::abs(near - wide), 10.0);
  find<QToolButton>("lookReset")->click();
  land();
  EXPECT_NEAR(focus()[1], wide, 1.0);
  clickRow(0);
  land();
  EXPECT_NEAR(focus()[1], near, 1e-6);
}

TEST_F(ContinuityPanel, APlaceInTheProfileIsFlownTo) {
  clickRow(4);
  QTest::mouseClick(figure, Qt::LeftButton, Qt::NoModifier, figure->pixelOf(0, 270.0, 0.0).toPoint());
  ASSERT_TRUE(figure->marked());
  EXPECT_NEAR(*figure->marked(), 270.0, 5.0);
  EXPECT_TRUE(waitUntil([this] { return std::abs(focus()[0]) > 30.0; }));
  const double v = *figure->marked();
  QTest::keyClick(figure, Qt::Key_Right);
  EXPECT_EQ(*figure->marked(), v + 1.0);
}

TEST_F(ContinuityPanel, EveryChoiceShowsAnotherFace) {
  auto* choice = find<QComboBox>("continuityFace");
  choice->setFocus();
  const QImage skin = face();
  std::vector<QImage> pictures = {skin};
  for (int i = 1; i < choice->count(); ++i) {
    QTest::keyClick(choice, Qt::Key_Down);
    ASSERT_EQ(choice->currentIndex(), i);
    EXPECT_GT(colorsIn("faceView"), 200) << i;
    for (const QImage& other : pictures) EXPECT_NE(face(), other) << i;
    pictures.push_back(face());
  }
  find<QToolButton>("faceSkin")->click();
  EXPECT_EQ(choice->currentIndex(), 0);
  EXPECT_EQ(face(), skin);
}

TEST_F(ContinuityPanel, StripesChangeWithTheScheme) {
  find<QComboBox>("continuityFace")->setCurrentIndex(4);
  const QImage before = face();
  window->model().change([](mien::FaceState& state) { state.surface.scheme = "spline"; });
  EXPECT_TRUE(waitUntil([&] { return face() != before; }));
}

TEST_F(ContinuityPanel, SchemesStandSideBySideAndADoubleClickUsesOne) {
  find<QComboBox>("continuityRows")->setCurrentIndex(1);
  ASSERT_EQ(table->rowCount(), 6);
  EXPECT_EQ(figure->figure().panels[0].series.size(), 6u);
  for (int row = 0; row < 6; ++row) {
    const std::string scheme = table->item(row, 0)->text().toStdString();
    if (scheme == "four-curve") {
      EXPECT_GT(angle(row), 10.0);
    }
    if (scheme != "spline") continue;
    EXPECT_LT(angle(row), 1e-6);
    const QPoint place = table->visualItemRect(table->item(row, 0)).center();
    QTest::mouseClick(table->viewport(), Qt::LeftButton, Qt::NoModifier, place);
    QTest::mouseDClick(table->viewport(), Qt::LeftButton, Qt::NoModifier, place);
  }
  EXPECT_EQ(window->model().state().surface.scheme, "spline");
}

TEST_F(ContinuityPanel, ASchemeThatRefusesHasNoNumbersButAReason) {
  window->model().change([](mien::FaceState& state) {
    state.surface.scheme = "spline";
    state.surface.smoothing.fill(300.0);
  });
  find<QComboBox>("continuityRows")->setCurrentIndex(1);
  ASSERT_TRUE(waitUntil([this] { return !table->item(0, 0)->toolTip().isEmpty(); }));
  EXPECT_EQ(table->item(0, 0)->text(), "four-curve");
  EXPECT_EQ(table->item(0, 3)->text(), QString::fromUtf8("\u2013"));
}

TEST_F(ContinuityPanel, TheFrontIsAPartOfTheWhole) {
  const double whole = angle(4);
  find<QComboBox>("continuityPart")->setCurrentIndex(1);
  EXPECT_LE(angle(4), whole);
  EXPECT_GT(angle(4), 0.0);
}

TEST_F(ContinuityPanel, WritesItsFigureAndNumbers) {
  auto* button = find<mien::ExportButton>("continuityExport");
  const QString name = QDir::temp().filePath(QString("mien_continuity_%1").arg(QCoreApplication::applicationPid()));
  for (const char* ending : {".svg", ".csv"}) EXPECT_TRUE(button->write(name + ending));
  QFile csv(name + ".csv");
  ASSERT_TRUE(csv.open(QIODevice::ReadOnly));
  EXPECT_EQ(csv.readAll().trimmed().split('\n').size(), 10);
  for (const char* ending : {".svg", ".csv"}) QFile::remove(name + ending);
}

}  // namespace
