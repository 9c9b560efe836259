#include "WholeRows.h"

#include <QAbstractItemModel>
#include <QHeaderView>
#include <QScrollBar>
#include <QTableView>
#include <algorithm>

namespace mien {

namespace {

constexpr int fewestRows = 2;

}  // namespace

WholeRows::WholeRows(QTableView* table, int leastRow, int mostRow, QWidget* parent)
    : QWidget(parent), table_(table), leastRow_(leastRow), mostRow_(mostRow) {
  table_->setParent(this);
  table_->setVerticalScrollMode(QAbstractItemView::ScrollPerItem);
  table_->verticalHeader()->setMinimumSectionSize(leastRow);
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  table_->verticalHeader()->setDefaultSectionSize(leastRow);
  connect(table_->horizontalScrollBar(), &QScrollBar::rangeChanged, this, &WholeRows::place);
  connect(table_->model(), &QAbstractItemModel::rowsInserted, this, &WholeRows::place);
  connect(table_->model(), &QAbstractItemModel::rowsRemoved, this, &WholeRows::place);
}

/// Of the table what is no row.
int WholeRows::around() const {
  const QScrollBar* below = table_->horizontalScrollBar();
  const QHeaderView* header = table_->horizontalHeader();
  return header->sizeHint().height() + 2 * table_->frameWidth() +
         (below->maximum() > below->minimum() ? below->sizeHint().height() : 0);
}

QSize WholeRows::sizeHint() const {
  return table_->sizeHint();
}

QSize WholeRows::minimumSizeHint() const {
  return {table_->minimumSizeHint().width(), around() + fewestRows * leastRow_};
}

void WholeRows::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  place();
}

void WholeRows::place() {
  const int all = table_->model()->rowCount(), room = height() - around();
  const int rows = std::clamp(room / leastRow_, 1, std::max(1, all));
  const int row = std::clamp(room / rows, leastRow_, mostRow_);
  if (table_->verticalHeader()->defaultSectionSize() != row) table_->verticalHeader()->setDefaultSectionSize(row);
  table_->setGeometry(0, 0, width(), around() + rows * row);
}

}  // namespace mien
