#include "MessageBar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QStyle>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <QVariant>

#include "Icons.h"
#include "MessageLog.h"
#include "SessionPart.h"

namespace mien {

namespace {

constexpr int detailsHeight = 90, spare = 12;  // pixels
constexpr int lineLetters = 70;                // that are read in noteTime

}  // namespace

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent),
      sentence_(new QLabel(this)),
      details_(new QPlainTextEdit(this)),
      more_(new QToolButton(this)),
      leaving_(new QTimer(this)) {
  setObjectName("messageBar");
  sentence_->setObjectName("messageSentence");
  sentence_->setWordWrap(true);
  sentence_->setTextFormat(Qt::PlainText);
  sentence_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  details_->setObjectName("messageDetails");
  details_->setReadOnly(true);
  details_->setFixedHeight(detailsHeight);
  details_->setTabChangesFocus(true);
  details_->setToolTip(tr("What else is known about this message"));
  leaving_->setSingleShot(true);
  leaving_->setInterval(noteTime);
  connect(leaving_, &QTimer::timeout, this, &QWidget::hide);
  auto* row = new QHBoxLayout;
  row->addWidget(sentence_, 1);
  buildButtons(row);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(10, 4, 6, 4);
  column->addLayout(row);
  column->addWidget(details_);
  details_->hide();
  hide();
}

void MessageBar::buildButtons(QLayout* row) {
  more_->setObjectName("messageMore");
  more_->setText(tr("Details"));
  more_->setToolTip(tr("What else is known about this message"));
  more_->setCheckable(true);
  more_->setProperty(notInSession, true);
  auto *log = new QToolButton(this), *close = new QToolButton(this);
  log->setObjectName("messageLogOpen");
  log->setText(tr("All messages"));
  log->setToolTip(tr("What was said since the start"));
  close->setObjectName("messageClose");
  close->setIcon(icon(Symbol::Close));
  close->setIconSize({11, 11});
  close->setToolTip(tr("Hide this message"));
  for (QToolButton* button : {more_, log, close}) {
    button->setFocusPolicy(Qt::TabFocus);
    row->addWidget(button);
  }
  connect(more_, &QToolButton::toggled, details_, &QWidget::setVisible);
  connect(more_, &QToolButton::toggled, this, &MessageBar::leaveLater);
  connect(more_, &QToolButton::toggled, this, &MessageBar::fitWidth);
  connect(log, &QToolButton::clicked, this, &MessageBar::showLog);
  connect(close, &QToolButton::clicked, this, &QWidget::hide);
}

QString MessageBar::sentence() const {
  return sentence_->text();
}

/// Not wider than its text, as what lies below is covered; details want room.
void MessageBar::fitWidth() {
  if (more_->isChecked()) return setMaximumWidth(QWIDGETSIZE_MAX);
  const int text = sentence_->fontMetrics().horizontalAdvance(sentence_->text());
  int buttons = 0;
  for (const QToolButton* button : findChildren<QToolButton*>())
    if (!button->isHidden()) buttons += button->sizeHint().width() + layout()->spacing();
  const QMargins around = layout()->contentsMargins();
  setMaximumWidth(text + buttons + around.left() + around.right() + spare);
}

void MessageBar::showError(const QString& sentence, const QString& details) {
  show("error", sentence, details);
}

void MessageBar::showNote(const QString& sentence, const QString& details) {
  show("note", sentence, details);
  leaving_->setInterval(noteTime * (1 + sentence.size() / lineLetters));
  leaveLater();
}

bool MessageBar::event(QEvent* event) {
  if (event->type() == QEvent::Enter || event->type() == QEvent::Leave) leaveLater();
  return QFrame::event(event);
}

/// What is being read stays.
void MessageBar::leaveLater() {
  const bool isRead = underMouse() || more_->isChecked();
  property("severity") == "note" && !isRead ? leaving_->start() : leaving_->stop();
}

void MessageBar::clearError() {
  if (property("severity") == "error") hide();
}

void MessageBar::showLog() {
  if (!shownLog_) {
    shownLog_ = new MessageLog(log_, window());
    shownLog_->setAttribute(Qt::WA_DeleteOnClose);
  }
  shownLog_->show();
  shownLog_->raise();
}

void MessageBar::show(const char* severity, const QString& sentence, const QString& details) {
  leaving_->stop();
  if (log_.size() == mostKept) log_.erase(log_.begin());
  log_.push_back({QDateTime::currentDateTime(), severity == QByteArray("error"), sentence, details});
  if (shownLog_) shownLog_->add(log_.back());
  setProperty("severity", severity);
  style()->unpolish(this);  // the style sheet chooses by severity
  style()->polish(this);
  sentence_->setText(sentence);
  details_->setPlainText(details);
  more_->setChecked(false);
  more_->setVisible(!details.isEmpty());
  fitWidth();
  setVisible(true);
}

}  // namespace mien
