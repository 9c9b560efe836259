#include "ShortcutDialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QTableWidget>
#include <QVBoxLayout>
#include <QVariant>

#include "SessionPart.h"
#include "ShortcutList.h"

namespace mien {

namespace {

constexpr int shortcutsWidth = 640, shortcutsHeight = 620;  // pixels
enum ShortcutColumn { Keys, Command, Place };

}  // namespace

ShortcutDialog::ShortcutDialog(const QWidget& window, QWidget* parent)
    : QDialog(parent), search_(new QLineEdit(this)), table_(new QTableWidget(this)) {
  setObjectName("shortcutDialog");
  setWindowTitle(tr("Keyboard shortcuts"));
  resize(shortcutsWidth, shortcutsHeight);
  search_->setObjectName("shortcutSearch");
  search_->setProperty(notInSession, true);
  search_->setPlaceholderText(tr("Find a key, a command or a dock"));
  search_->setToolTip(tr("Shows the rows that hold this text"));
  search_->setClearButtonEnabled(true);
  connect(search_, &QLineEdit::textChanged, this, &ShortcutDialog::filter);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->addWidget(search_);
  column->addWidget(table_, 1);
  column->addWidget(buttons);
  fill(window);
}

void ShortcutDialog::fill(const QWidget& window) {
  const std::vector<ShortcutEntry> entries = shortcutsOf(window);
  table_->setObjectName("shortcutTable");
  table_->setColumnCount(3);
  table_->setHorizontalHeaderLabels({tr("Keys"), tr("Command"), tr("Where")});
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setShowGrid(false);
  table_->setAlternatingRowColors(true);
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->setRowCount(static_cast<int>(entries.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    table_->setItem(row, Keys, new QTableWidgetItem(entries[row].keys));
    table_->setItem(row, Command, new QTableWidgetItem(entries[row].command));
    table_->setItem(row, Place, new QTableWidgetItem(entries[row].place));
  }
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(Command, QHeaderView::Stretch);
  table_->setWordWrap(true);
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
}

void ShortcutDialog::filter() {
  for (int row = 0; row < table_->rowCount(); ++row) {
    bool holds = false;
    for (int column = 0; column < table_->columnCount(); ++column)
      holds = holds || table_->item(row, column)->text().contains(search_->text(), Qt::CaseInsensitive);
    table_->setRowHidden(row, !holds);
  }
}

}  // namespace mien
