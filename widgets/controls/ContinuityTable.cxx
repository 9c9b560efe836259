#include "ContinuityTable.h"

#include <vtkTable.h>
#include <vtkVariant.h>

#include <QHeaderView>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

#include "SeamMeasureKind.h"

namespace mien {

namespace {

constexpr double smallest = 1e-3;
constexpr int headMargins = 8;         // pixels
constexpr double smallerHeads = 0.85;  // of the application's letters: seven heads in half a dock

QString seamNumberText(double value) {
  if (!std::isfinite(value)) return QStringLiteral("\u2013");
  if (value == 0.0) return QStringLiteral("0");
  if (std::abs(value) < smallest) return QString::number(value, 'g', 1).replace("e-0", "e-");  // has to fit its column
  return QString::number(value, 'g', 3);
}

}  // namespace

ContinuityTable::ContinuityTable(QWidget* parent) : QTableWidget(parent) {
  setObjectName("continuityTable");
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setTabKeyNavigation(false);
  setAlternatingRowColors(true);
  setShowGrid(false);
  setFrameShape(QFrame::NoFrame);
  verticalHeader()->hide();
  horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  horizontalHeader()->setHighlightSections(false);
  QFont small = horizontalHeader()->font();
  small.setPointSizeF(smallerHeads * small.pointSizeF());
  horizontalHeader()->setFont(small);
  const std::vector<SeamSummaryColumn>& columns = SeamSummaryColumn::all();
  setColumnCount(static_cast<int>(columns.size()) + 1);
  int widest = 0;
  for (size_t i = 0; i < columns.size(); ++i) {
    auto* header = new QTableWidgetItem(QString::fromUtf8(columns[i].header));
    header->setToolTip(columns[i].toolTip);
    setHorizontalHeaderItem(static_cast<int>(i) + 1, header);
    for (const QString& line : header->text().split('\n'))
      widest = std::max(widest, horizontalHeader()->fontMetrics().horizontalAdvance(line));
  }
  horizontalHeader()->setMinimumSectionSize(widest + headMargins);
  horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  setMinimumWidth(300);
}

void ContinuityTable::setRowNames(const QString& title, const QStringList& names) {
  setHorizontalHeaderItem(0, new QTableWidgetItem(title + "\n"));
  bool same = rowCount() == names.size();
  for (int row = 0; same && row < rowCount(); ++row) same = item(row, 0)->text() == names[row];
  if (same) return;
  const QSignalBlocker quiet(this);
  setRowCount(0);
  setRowCount(names.size());
  for (int row = 0; row < rowCount(); ++row)
    for (int column = 0; column < columnCount(); ++column) {
      auto* cell = new QTableWidgetItem(column == 0 ? names[row] : QString());
      cell->setTextAlignment((column == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
      setItem(row, column, cell);
    }
}

void ContinuityTable::setSummary(int row, vtkTable* summary, int sourceRow, bool frontal) {
  const std::vector<SeamSummaryColumn>& columns = SeamSummaryColumn::all();
  item(row, 0)->setToolTip(QString());
  for (size_t i = 0; i < columns.size(); ++i) {
    const std::string name = (frontal ? "frontal_" : "") + std::string(columns[i].name);
    item(row, static_cast<int>(i) + 1)
        ->setText(seamNumberText(summary->GetValueByName(sourceRow, name.c_str()).ToDouble()));
  }
}

void ContinuityTable::setFault(int row, const QString& why) {
  item(row, 0)->setToolTip(why);
  for (int column = 1; column < columnCount(); ++column) item(row, column)->setText(QStringLiteral("\u2013"));
}

QSize ContinuityTable::sizeHint() const {
  return {470, 9 * leastLine + 40};
}

}  // namespace mien
