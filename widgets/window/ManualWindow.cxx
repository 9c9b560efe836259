#include "ManualWindow.h"

#include <QAction>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>
#include <QSplitter>
#include <QTextBrowser>
#include <QVBoxLayout>
#include <QVariant>

#include "ManualPage.h"
#include "SessionPart.h"
#include "Theme.h"

namespace mien {

namespace {

constexpr int manualWidth = 980, manualHeight = 720, contentsWidth = 210;  // pixels

/// Names in @ stand for colours of the theme.
const char* const styleText = R"(
h1 { font-size: xx-large; font-weight: 600; }
h2 { font-size: x-large; font-weight: 600; color: @accent; margin-top: 26px; }
h3 { font-size: medium; font-weight: 600; margin-top: 14px; }
th { text-align: left; color: @faint; font-weight: 600; padding: 3px 14px 3px 0px; }
td { padding: 3px 14px 3px 0px; }
a { color: @accent; text-decoration: none; }
code { font-family: monospace; }
)";

QString pageStyle() {
  const Theme& theme = Theme::current();
  return QString(styleText).replace("@accent", theme.accent.name()).replace("@faint", theme.faintText.name());
}

QString text() {
  return QString::fromStdString(ManualPage());
}

}  // namespace

ManualWindow::ManualWindow(QWidget* parent)
    : QWidget(parent, Qt::Window),
      page_(new QTextBrowser(this)),
      contents_(new QListWidget(this)),
      search_(new QLineEdit(this)) {
  setObjectName("manualWindow");
  setWindowTitle(tr("Manual"));
  resize(manualWidth, manualHeight);
  page_->setObjectName("manualPage");
  page_->setOpenExternalLinks(true);
  page_->setFrameShape(QFrame::NoFrame);
  auto* both = new QSplitter(Qt::Horizontal, this);
  both->addWidget(side());
  both->addWidget(page_);
  both->setStretchFactor(1, 1);
  both->setSizes({contentsWidth, manualWidth - contentsWidth});
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 8, 8, 8);
  column->addWidget(both);
  listSections();
  dress();
  setTabOrder(search_, contents_);
  setTabOrder(contents_, page_);
}

QWidget* ManualWindow::side() {
  search_->setObjectName("manualSearch");
  search_->setProperty(notInSession, true);
  search_->setPlaceholderText(tr("Find (Ctrl+F)"));
  search_->setToolTip(tr("Words of the manual; Return finds the next place, Shift+Return the one before"));
  search_->setAccessibleName(tr("Find in the manual"));
  search_->setClearButtonEnabled(true);
  search_->installEventFilter(this);
  connect(search_, &QLineEdit::textEdited, this, [this] {
    page_->moveCursor(QTextCursor::Start);
    find(false);
  });
  contents_->setObjectName("manualContents");
  contents_->setToolTip(tr("The sections of the manual"));
  connect(contents_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
    if (item) page_->scrollToAnchor(item->data(Qt::UserRole).toString());
  });
  auto* action = new QAction(tr("Find"), this);
  action->setShortcut(QKeySequence::Find);
  connect(action, &QAction::triggered, this, [this] {
    search_->setFocus();
    search_->selectAll();
  });
  addAction(action);
  auto* box = new QWidget(this);
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(search_);
  column->addWidget(contents_, 1);
  return box;
}

void ManualWindow::listSections() {
  static const QRegularExpression heading("<h2><a name=\"([^\"]+)\">([^<]+)</a></h2>");
  auto found = heading.globalMatch(text());
  while (found.hasNext()) {
    const QRegularExpressionMatch match = found.next();
    auto* item = new QListWidgetItem(match.captured(2), contents_);
    item->setData(Qt::UserRole, match.captured(1));
  }
}

/// A document keeps the colours that it was made with.
void ManualWindow::dress() {
  page_->document()->setDefaultStyleSheet(pageStyle());
  page_->document()->setDocumentMargin(18);
  page_->setHtml(text());
}

void ManualWindow::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) {
    dress();
    page_->scrollToAnchor(section());
  }
  QWidget::changeEvent(event);
}

QString ManualWindow::sectionOf(const QWidget* widget) const {
  for (; widget; widget = widget->parentWidget())
    for (int row = 0; row < contents_->count(); ++row)
      if (contents_->item(row)->data(Qt::UserRole) == widget->objectName()) return widget->objectName();
  return contents_->item(0)->data(Qt::UserRole).toString();
}

QString ManualWindow::section() const {
  const QListWidgetItem* item = contents_->currentItem();
  return item ? item->data(Qt::UserRole).toString() : QString();
}

void ManualWindow::showSection(const QString& anchor) {
  show();
  raise();
  activateWindow();
  for (int row = 0; row < contents_->count(); ++row)
    if (contents_->item(row)->data(Qt::UserRole) == anchor) contents_->setCurrentRow(row);
  page_->scrollToAnchor(anchor);
  page_->setFocus();
}

/// From the other end where there is nothing more.
void ManualWindow::find(bool backward) {
  const QTextDocument::FindFlags flags = backward ? QTextDocument::FindBackward : QTextDocument::FindFlags();
  if (search_->text().isEmpty() || page_->find(search_->text(), flags)) return;
  page_->moveCursor(backward ? QTextCursor::End : QTextCursor::Start);
  page_->find(search_->text(), flags);
}

void ManualWindow::keyPressEvent(QKeyEvent* event) {
  event->key() == Qt::Key_Escape ? hide() : QWidget::keyPressEvent(event);
}

bool ManualWindow::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
  const auto* key = static_cast<QKeyEvent*>(event);
  if (key->key() != Qt::Key_Return && key->key() != Qt::Key_Enter) return false;
  find(key->modifiers() & Qt::ShiftModifier);
  return true;
}

}  // namespace mien
