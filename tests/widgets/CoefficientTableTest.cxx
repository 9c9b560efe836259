#include <QAction>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QRegularExpression>
#include <cmath>

#include "CoefficientTable.h"
#include "FaceModel.h"
#include "NamedTables.h"
#include "StudioFixture.h"
#include "TableStatistics.h"

namespace {

class CoefficientTable : public StudioFixture {
 protected:
  CoefficientTable() {
    find<QAction>("deformationDockAction")->trigger();
    cells = find<mien::CoefficientTable>("deformationCoefficients");
    EXPECT_TRUE(waitUntil([this] { return !cells->text().empty(); }));
  }

  void choose(const QString& name) {
    auto* box = find<QComboBox>("deformationTable");
    box->setCurrentIndex(box->findText(name));
    settle();
  }

  void showJoy() {
    window->model().change([](mien::FaceState& state) { state.expressions = {{"joy", 1.0}}; });
    auto* label = find<QLabel>("deformationExpression");
    ASSERT_TRUE(waitUntil([&] { return label->isVisible() && label->text().startsWith("Nearest: joy, "); }));
  }

  mien::CoefficientTable* cells;
};

/// One format: a leading zero, as many decimals in all rows of a column, and no more than half of the last one lost.
TEST_F(CoefficientTable, EveryColumnIsWrittenInOneFormat) {
  choose("Joy");
  find<QComboBox>("deformationShown")->setCurrentIndex(1);
  const mien::DeformationTable& joy = *mien::namedTable("joy");
  const QRegularExpression format(QString::fromUtf8("^\u2212?(0|[1-9][0-9]*)\\.([0-9]{2})$"));
  for (int i = 0; i < 192; ++i) {
    const double value = joy.maps[i / 12].coefficients(i % 12 / 6, i % 6);
    QString text = cells->item(i / 12, i % 12)->text();
    EXPECT_TRUE(format.match(text).hasMatch()) << text.toStdString();
    EXPECT_NE(text, QString::fromUtf8("\u22120.00"));
    EXPECT_LE(std::abs(text.replace(QChar(0x2212), '-').toDouble() - value), 0.00501) << i;
  }
}

/// What a reader sees as the limit itself does not stand out, nor what rounding alone sets apart from it.
TEST_F(CoefficientTable, WhatReadsAsTheLimitIsNotMarked) {
  const mien::DeformationTable& joy = *mien::namedTable("joy");
  mien::DeformationTable near = joy, rounded = joy, far = joy;
  int tried = 0, apart = 0;
  for (int i = 0; i < 192; ++i) {
    const double limit =
        joy.maps[i / 12].coefficients(i % 12 / 6, i % 6) + joy.deviations->at(i / 12)(i % 12 / 6, i % 6);
    const double shown = std::round(100.0 * limit) / 100.0;  // the middle of what reads so
    near.maps[i / 12].coefficients(i % 12 / 6, i % 6) = shown + 0.004;
    rounded.maps[i / 12].coefficients(i % 12 / 6, i % 6) = limit + 0.0099;
    far.maps[i / 12].coefficients(i % 12 / 6, i % 6) = shown + 0.016;
  }
  const std::vector<int> beyond = mien::outsideRange(near, joy);
  EXPECT_GT(beyond.size(), 20u) << "else none of them is tried";
  cells->show(near, "joy", &joy, nullptr);
  for (int i = 0; i < 192; ++i) EXPECT_FALSE(cells->item(i / 12, i % 12)->font().bold()) << i;
  cells->show(rounded, "joy", &joy, nullptr);
  for (int i = 0; i < 192; ++i) {
    const double limit =
        joy.maps[i / 12].coefficients(i % 12 / 6, i % 6) + joy.deviations->at(i / 12)(i % 12 / 6, i % 6);
    apart += std::lround(100.0 * (limit + 0.0099)) != std::lround(100.0 * limit);
    EXPECT_FALSE(cells->item(i / 12, i % 12)->font().bold()) << i;
    EXPECT_TRUE(cells->item(i / 12, i % 12)->toolTip().contains(QString::number(limit, 'g', 9))) << i;
  }
  EXPECT_GT(apart, 150) << "else none reads as beyond the limit";
  cells->show(far, "joy", &joy, nullptr);
  for (int i : beyond) tried += cells->item(i / 12, i % 12)->font().bold();
  EXPECT_EQ(tried, static_cast<int>(beyond.size()));
}

/// No row is cut through, and where all have room the table ends with the last.
TEST_F(CoefficientTable, TheTableEndsBelowAWholeRow) {
  showJoy();
  find<QAction>("actionWorkspace3")->trigger();
  struct Seen {
    QSize window;
    int leastRows;
  };
  for (const Seen& seen : {Seen{{1000, 700}, 6}, Seen{{1280, 800}, 8}, Seen{{1280, 857}, 8}, Seen{{2560, 1440}, 16}}) {
    window->resize(seen.window);
    find<QAction>("actionResetWorkspace")->trigger();
    settle();
    const int row = cells->verticalHeader()->defaultSectionSize(), height = cells->viewport()->height();
    EXPECT_EQ(height % row, 0) << seen.window.width();
    EXPECT_GE(height / row, seen.leastRows) << seen.window.width();
    EXPECT_LE(height / row, 16);
    EXPECT_GE(row, mien::CoefficientTable::leastLine);
  }
}

/// What is rounding beside the map that it belongs to reads 0, and what differs from the mean by no more than the table
/// can show does not stand out.
TEST_F(CoefficientTable, RoundingIsNotMarked) {
  showJoy();
  const mien::DeformationTable& joy = *mien::namedTable("joy");
  const QStringList rows = QString::fromStdString(cells->text()).split('\n');
  int rounding = 0, marked = 0;
  for (int i = 0; i < 192; ++i) {
    const double value = rows[i + 1].section(',', 3, 3).toDouble();
    const double mean = joy.maps[i / 12].coefficients(i % 12 / 6, i % 6);
    const QTableWidgetItem* cell = cells->item(i / 12, i % 12);
    rounding += std::abs(value) < 1e-6;
    marked += cell->font().bold();
    if (std::abs(value) < 1e-6) {
      EXPECT_EQ(cell->text().at(0), '0') << value;
    }
    if (std::abs(value - mean) < 0.004) {
      EXPECT_FALSE(cell->font().bold()) << value << " beside " << mean;
    }
  }
  EXPECT_GT(rounding, 10) << "else none is tried";
  EXPECT_GT(marked, 10);
}

}  // namespace
