#include "CoefficientTable.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QScrollBar>
#include <algorithm>
#include <cmath>

#include "DefaultRegions.h"
#include "NumberText.h"
#include "RangeDelegate.h"
#include "TableStatistics.h"

namespace mien {

namespace {

constexpr int coefficientCount = 12, rmsColumn = 12, allColumns = 13;
constexpr int decimalsOfColumn = 2, shownDigits = 9;  // in a cell, and where there is room
constexpr double smaller = 0.85;                      // of the application's letters: 13 columns in half a window
constexpr int shownRows = 10, leastWidth = 44, headerMargins = 14;  // pixels
constexpr const char* factors[] = {"x\u00b2", "x y", "y\u00b2", "x", "y", "1"};
constexpr const char* shortUnits[] = {"1/pu", "1/pu", "1/pu", "\u2013", "\u2013", "pu"};
constexpr const char* units[] = {"1/pupil unit", "1/pupil unit", "1/pupil unit", "no unit", "no unit", "pupil units"};

double valueOf(const DeformationTable& table, int region, int coefficient) {
  return table.maps[region - 1].coefficients(coefficient / 6, coefficient % 6);
}

double deviationOf(const DeformationTable& mean, int region, int coefficient) {
  return mean.deviations->at(region - 1)(coefficient / 6, coefficient % 6);
}

QString sideText(int side) {
  return side == 0  ? CoefficientTable::tr("within")
         : side < 0 ? CoefficientTable::tr("below")
                    : CoefficientTable::tr("above");
}

/// With so many decimals, and the sign of what does not read 0.
QString cellText(double value, int decimals) {
  const QString text = QString::number(value, 'f', decimals);
  return text.toDouble() == 0.0 ? QString::number(0.0, 'f', decimals) : QString(text).replace('-', QChar(0x2212));
}

/// Of all numbers in a column, so that it reads as one: fewer where the largest would not fit.
int decimalsOf(const DeformationTable& table, int coefficient) {
  double largest = 0.0;
  for (int region = 1; region <= DeformationTable::regionCount; ++region)
    largest = std::max(largest, std::abs(valueOf(table, region, coefficient)));
  return std::clamp(decimalsOfColumn - static_cast<int>(std::log10(std::max(largest, 1.0))), 0, decimalsOfColumn);
}

QString regionText(int region) {
  return QString("%1 %2").arg(region).arg(QString::fromStdString(defaultRegions().name(region)));
}

/// Of the longest names only what tells them apart; the tooltip and the line below have all of it.
QString shortRegionText(int region) {
  return regionText(region).section(" and ", 0, 0).remove(" corner");
}

}  // namespace

CoefficientTable::CoefficientTable(QWidget* parent) : QTableWidget(DeformationTable::regionCount, allColumns, parent) {
  setObjectName("deformationCoefficients");
  setAccessibleName(tr("Coefficients of the 16 regions"));
  setToolTip(tr("A click, or Return, shows a region on the face; Ctrl+C copies all coefficients as CSV"));
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setTabKeyNavigation(false);
  setShowGrid(false);
  setAlternatingRowColors(true);
  setFrameShape(QFrame::NoFrame);
  setItemDelegate(new RangeDelegate(this));
  QFont small = font();
  small.setPointSizeF(smaller * small.pointSizeF());
  setFont(small);
  addHeaders();
  addCells();
  auto* copy = new QAction(tr("Copy as CSV"), this);
  copy->setObjectName("deformationCopy");
  copy->setShortcut(QKeySequence::Copy);
  copy->setShortcutContext(Qt::WidgetShortcut);
  addAction(copy);
  setContextMenuPolicy(Qt::ActionsContextMenu);
  connect(copy, &QAction::triggered, this,
          [this] { QApplication::clipboard()->setText(QString::fromStdString(text())); });
}

void CoefficientTable::addHeaders() {
  for (int i = 0; i < coefficientCount; ++i) {
    const QString name = QString::fromStdString(coefficientName(i));
    auto* header = new QTableWidgetItem(name + '\n' + QString::fromUtf8(shortUnits[i % 6]));
    header->setToolTip(
        tr("%1: factor of %2 in %3' (%4; pu is one pupil unit, half the distance of the pupils); the "
           "scale below a number is mean \u00b1 sd of the expression. Red and bold is what lies outside it by "
           "one or more of the last decimal shown, and differs from the mean by more than 0.5 % of the "
           "largest factor in the mean's region")
            .arg(name, QString::fromUtf8(factors[i % 6]), i < 6 ? "x" : "y", units[i % 6]));
    setHorizontalHeaderItem(i, header);
  }
  auto* rms = new QTableWidgetItem(tr("RMS\npu"));
  rms->setToolTip(tr("Root mean square of what the fit leaves in the region, in pupil units"));
  setHorizontalHeaderItem(rmsColumn, rms);
  for (int region = 1; region <= rowCount(); ++region) {
    auto* header = new QTableWidgetItem(shortRegionText(region));
    header->setFont(font());
    header->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    header->setToolTip(regionText(region));
    setVerticalHeaderItem(region - 1, header);
  }
  int widest = 0;
  for (int region = 0; region < rowCount(); ++region)
    widest = std::max(widest, QFontMetrics(font()).horizontalAdvance(verticalHeaderItem(region)->text()));
  verticalHeader()->setFixedWidth(widest + headerMargins);
  horizontalHeader()->setMinimumSectionSize(leastWidth);
  horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  horizontalHeader()->setHighlightSections(false);
}

void CoefficientTable::addCells() {
  for (int row = 0; row < rowCount(); ++row)
    for (int column = 0; column < allColumns; ++column) {
      auto* cell = new QTableWidgetItem;
      setItem(row, column, cell);
    }
}

void CoefficientTable::show(const DeformationTable& table, const std::string& meanName, const DeformationTable* mean,
                            const PresentTable::Fit* fit) {
  table_ = table;
  shown_ = true;
  hasMean_ = mean;
  if (mean) mean_ = *mean;
  meanName_ = meanName;
  for (int region = 1; region <= rowCount(); ++region) {
    for (int coefficient = 0; coefficient < coefficientCount; ++coefficient) fillCoefficient(region, coefficient);
    fillFit(region, fit);
  }
  setColumnHidden(rmsColumn, !fit);
}

void CoefficientTable::fillCoefficient(int region, int coefficient) {
  const double value = valueOf(table_, region, coefficient);
  const double difference = hasMean_ ? value - valueOf(mean_, region, coefficient) : 0.0;
  const double deviation = hasMean_ ? deviationOf(mean_, region, coefficient) : 0.0;
  const int side = hasMean_ ? sideOfRange(table_, mean_, region, coefficient) : 0;
  const int decimals = decimalsOf(table_, coefficient);
  const double beyond = side * difference - deviation;  // the limit
  QTableWidgetItem* cell = item(region - 1, coefficient);
  cell->setText(cellText(value, decimals));
  const bool standsOut = side != 0 && beyond >= std::pow(10.0, -decimals);  // as it is read, too
  cell->setData(RangeDelegate::outsideRole, standsOut);
  cell->setToolTip(hasMean_ ? rangeWords(region, coefficient, standsOut) : QString());
  cell->setData(RangeDelegate::placeRole, deviation > 0.0 ? QVariant(difference / deviation) : QVariant());
  QFont font = this->font();
  font.setBold(standsOut);
  cell->setFont(font);
  cell->setData(Qt::AccessibleTextRole, tr("region %1, %2: %3, %4")
                                            .arg(region)
                                            .arg(QString::fromStdString(coefficientName(coefficient)))
                                            .arg(value)
                                            .arg(hasMean_ ? sideText(side) : tr("no range")));
}

void CoefficientTable::fillFit(int region, const PresentTable::Fit* fit) {
  if (!fit) return;
  item(region - 1, rmsColumn)->setText(QString::number(fit->rms[region - 1], 'f', 3));
  item(region - 1, rmsColumn)->setToolTip(tr("RMS of %1 points, in pupil units").arg(fit->points[region - 1]));
}

QString CoefficientTable::detail() const {
  if (!shown_ || currentRow() < 0) return legend();
  if (currentColumn() >= coefficientCount) return regionText(chosenRegion());
  return wordsOf(chosenRegion(), currentColumn());
}

QString CoefficientTable::legend() const {
  if (!shown_ || !hasMean_) return tr("Choose a coefficient to read it with its range.");
  return tr("Red and bold: outside mean \u00b1 sd of %1 by 1 in the last decimal or more")
      .arg(QString::fromStdString(meanName_));
}

QString CoefficientTable::wordsOf(int region, int coefficient) const {
  const QString name = regionText(region);
  const auto number = [](double x) { return QString::number(x, 'g', 4); };
  const double value = valueOf(table_, region, coefficient);
  if (!hasMean_)
    return tr("%1: %2 = %3 (%4); the face does not move, so no mean is near")
        .arg(name, QString::fromStdString(coefficientName(coefficient)), number(value), units[coefficient % 6]);
  const double mean = valueOf(mean_, region, coefficient), deviation = deviationOf(mean_, region, coefficient);
  return tr("%1: %2 = %3 (%4), %5 %6 \u00b1 %7 of %8")
      .arg(name, QString::fromStdString(coefficientName(coefficient)), number(value), units[coefficient % 6],
           sideText(sideOfRange(table_, mean_, region, coefficient)), number(mean), number(deviation),
           QString::fromStdString(meanName_));
}

QString CoefficientTable::rangeWords(int region, int coefficient, bool standsOut) const {
  const auto number = [](double x) { return QString::number(x, 'g', shownDigits); };
  const double mean = valueOf(mean_, region, coefficient), deviation = deviationOf(mean_, region, coefficient);
  const int side = sideOfRange(table_, mean_, region, coefficient);
  const QString words = tr("%1: %2 = %3 (%4), %5 mean \u00b1 sd of %6, which is %7 to %8")
                            .arg(regionText(region), QString::fromStdString(coefficientName(coefficient)),
                                 number(valueOf(table_, region, coefficient)), units[coefficient % 6], sideText(side),
                                 QString::fromStdString(meanName_), number(mean - deviation), number(mean + deviation));
  return side == 0 || standsOut ? words : words + tr("; not marked: by less than one of the last decimal shown");
}

std::string CoefficientTable::text() const {
  if (!shown_) return {};
  std::string text = "region,name,coefficient,value" + (hasMean_ ? ",mean_" + meanName_ + ",sd,range\n" : "\n");
  for (int region = 1; region <= rowCount(); ++region)
    for (int i = 0; i < coefficientCount; ++i) {
      const double value = valueOf(table_, region, i);
      text += std::to_string(region) + "," + defaultRegions().name(region) + "," + coefficientName(i);
      if (!hasMean_) {
        appendNumber(text += ",", value);
        text += "\n";
        continue;
      }
      const double mean = valueOf(mean_, region, i), deviation = deviationOf(mean_, region, i);
      for (double number : {value, mean, deviation}) appendNumber(text += ",", number);
      const int side = sideOfRange(table_, mean_, region, i);
      text += side == 0 ? ",inside\n" : side < 0 ? ",below\n" : ",above\n";
    }
  return text;
}

QSize CoefficientTable::sizeHint() const {
  return {
      allColumns * leastWidth + verticalHeader()->width() + verticalScrollBar()->sizeHint().width() + 2 * frameWidth(),
      shownRows * leastLine + horizontalHeader()->sizeHint().height()};
}

}  // namespace mien
