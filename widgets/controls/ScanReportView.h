#pragma once

#include <QString>
#include <vector>

#include "GrowingText.h"

namespace mien {

struct ScanReportLine;

/// What was found on a scan, to be read and copied; each line tells its details where the mouse rests on it.
class ScanReportView : public GrowingText {
  Q_OBJECT
 public:
  explicit ScanReportView(QWidget* parent = nullptr);

  void begin();  ///< anew
  void addLine(const QString& text, const QString& detail = QString());
  void addLines(const std::vector<ScanReportLine>& lines);
  void end();  ///< shows what was added; a text that is as before keeps what is selected in it

 private:
  QStringList lines_, details_;
};

}  // namespace mien
