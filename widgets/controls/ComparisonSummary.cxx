#include "ComparisonSummary.h"

#include <QEvent>
#include <algorithm>

namespace mien {

namespace {

constexpr int underLines = 4;  // pixels: text that can be selected is laid out a little lower

/// As long as a summary gets: its place is kept, so that the views stay as high while the numbers change.
QString longestSummary() {
  return ComparisonSummary::tr("Point to point, by area of A: RMS 88.88, 95 % \u2264 88.88, max 88.88 mm");
}

/// As many of the pieces on each line as it holds, and one at least.
QStringList filled(const QStringList& pieces, const QFontMetrics& metrics, int width) {
  const QString comma = ", ";
  QStringList lines;
  for (const QString& piece : pieces) {
    const bool fits = !lines.isEmpty() && metrics.horizontalAdvance(lines.last() + comma + piece + ',') <= width;
    if (fits) lines.last() += comma + piece;
    if (fits) continue;
    if (!lines.isEmpty()) lines.last() += ',';
    lines << piece;
  }
  return lines;
}

}  // namespace

ComparisonSummary::ComparisonSummary(QWidget* parent) : QLabel(parent) {
  setTextFormat(Qt::PlainText);
  setTextInteractionFlags(Qt::TextSelectableByMouse);
  setAlignment(Qt::AlignLeft | Qt::AlignTop);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

void ComparisonSummary::setTwin(ComparisonSummary* twin) {
  twin_ = twin;
  twin->twin_ = this;
}

void ComparisonSummary::setSummary(const QString& summary) {
  if (summary == summary_) return;
  summary_ = summary;
  layOut();
}

QSize ComparisonSummary::minimumSizeHint() const {
  return {1, QLabel::minimumSizeHint().height()};
}

QStringList ComparisonSummary::lines(const QString& summary) const {
  const QFontMetrics metrics = fontMetrics();
  const int width = contentsRect().width(), colon = summary.indexOf(": ");
  const bool isWide = metrics.horizontalAdvance(longestSummary()) <= width;
  if (colon < 0 || (isWide && metrics.horizontalAdvance(summary) <= width)) return {summary};
  return filled(summary.left(colon + 1).split(", "), metrics, width) +
         filled(summary.mid(colon + 2).split(", "), metrics, width);
}

int ComparisonSummary::linesNeeded() const {
  return std::max(lines(summary_).size(), lines(longestSummary()).size());
}

void ComparisonSummary::layOut() {
  ensurePolished();
  const bool hasTwin = twin_ && twin_->isVisible();
  const int needed = hasTwin ? std::max(linesNeeded(), twin_->linesNeeded()) : linesNeeded();
  setText(lines(summary_).join('\n'));
  takeHeight(needed);
  if (hasTwin) twin_->takeHeight(needed);
}

void ComparisonSummary::takeHeight(int lines) {
  const QMargins margins = contentsMargins();
  setFixedHeight(lines * fontMetrics().lineSpacing() + margins.top() + margins.bottom() + underLines);
}

void ComparisonSummary::resizeEvent(QResizeEvent* event) {
  QLabel::resizeEvent(event);
  layOut();
}

/// From now on the twin counts.
void ComparisonSummary::showEvent(QShowEvent* event) {
  QLabel::showEvent(event);
  layOut();
}

void ComparisonSummary::changeEvent(QEvent* event) {
  QLabel::changeEvent(event);
  if (event->type() == QEvent::FontChange) layOut();
}

}  // namespace mien
