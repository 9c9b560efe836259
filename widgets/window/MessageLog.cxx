#include "MessageLog.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QHeaderView>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "Theme.h"

namespace mien {

namespace {

constexpr int logWidth = 760, logHeight = 420, logDetailsHeight = 100;  // pixels
enum LogColumn { Time, Kind, Sentence };

}  // namespace

MessageLog::MessageLog(const std::vector<Message>& messages, QWidget* parent)
    : QDialog(parent), list_(new QTreeWidget(this)), details_(new QPlainTextEdit(this)) {
  setObjectName("messageLog");
  setWindowTitle(tr("Messages"));
  resize(logWidth, logHeight);
  list_->setObjectName("messageLogList");
  list_->setHeaderLabels({tr("Time"), tr("Kind"), tr("Message")});
  list_->setRootIsDecorated(false);
  list_->setAlternatingRowColors(true);
  list_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  list_->header()->setStretchLastSection(true);
  details_->setObjectName("messageLogDetails");
  details_->setReadOnly(true);
  details_->setFixedHeight(logDetailsHeight);
  details_->setPlaceholderText(tr("Choose a message to read all of it."));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  QPushButton* copied = buttons->addButton(tr("&Copy all"), QDialogButtonBox::ActionRole);
  copied->setObjectName("messageLogCopy");
  connect(copied, &QPushButton::clicked, this, &MessageLog::copy);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(list_, &QTreeWidget::currentItemChanged, this, [this](const QTreeWidgetItem* item) {
    details_->setPlainText(item ? item->data(Sentence, Qt::UserRole).toString() : QString());
  });
  auto* column = new QVBoxLayout(this);
  column->addWidget(list_, 1);
  column->addWidget(details_);
  column->addWidget(buttons);
  for (const Message& message : messages) add(message);
  if (messages.empty()) details_->setPlaceholderText(tr("Nothing was said yet."));
}

void MessageLog::add(const Message& message) {
  auto* item = new QTreeWidgetItem(
      {message.time.toString("HH:mm:ss"), message.isError ? tr("Error") : tr("Note"), message.sentence});
  const QString whole = message.details.isEmpty() ? message.sentence : message.sentence + "\n\n" + message.details;
  item->setData(Sentence, Qt::UserRole, whole);
  item->setToolTip(Sentence, message.sentence);
  if (message.isError) item->setForeground(Kind, Theme::current().error);
  list_->insertTopLevelItem(0, item);
  details_->setPlaceholderText(tr("Choose a message to read all of it."));
}

void MessageLog::copy() const {
  QStringList lines;
  for (int i = list_->topLevelItemCount() - 1; i >= 0; --i) {
    const QTreeWidgetItem* item = list_->topLevelItem(i);
    lines << item->text(Time) + ' ' + item->text(Kind) + ": " + item->data(Sentence, Qt::UserRole).toString();
  }
  QGuiApplication::clipboard()->setText(lines.join('\n'));
}

}  // namespace mien
