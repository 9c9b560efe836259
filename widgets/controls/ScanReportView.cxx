#include "ScanReportView.h"

#include <QFontDatabase>
#include <QTextDocument>

#include "ScanReportText.h"

namespace mien {

namespace {

constexpr double reportMargin = 2.0;  // pixels

}  // namespace

ScanReportView::ScanReportView(QWidget* parent) : GrowingText(parent) {
  setObjectName("scanReport");
  setToolTip(tr("What was found on the scan; a line tells its details where the mouse rests on it"));
  setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  setFrameShape(QFrame::NoFrame);
  document()->setDocumentMargin(reportMargin);
  viewport()->setAutoFillBackground(false);
}

void ScanReportView::begin() {
  lines_.clear();
  details_.clear();
}

void ScanReportView::addLine(const QString& text, const QString& detail) {
  lines_ << text;
  details_ << detail;
}

void ScanReportView::addLines(const std::vector<ScanReportLine>& lines) {
  for (const ScanReportLine& line : lines) addLine("  " + line.text(), line.detail);
}

void ScanReportView::end() {
  setDetails(details_);
  if (const QString text = lines_.join('\n'); text != toPlainText()) setPlainText(text);
}

}  // namespace mien
