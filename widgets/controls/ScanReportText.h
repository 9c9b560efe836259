#pragma once

#include <QString>
#include <vector>

namespace mien {

struct AcquireResult;

/// A line of what was found on a scan, in words for who knows faces, and its details for who knows scans.
struct ScanReportLine {
  QString name, value, detail;

  QString text() const;  ///< name and value, in letters of one width below those of the other lines
};

/// Mesh with its unit, pose, landmarks, distance, crossings.
std::vector<ScanReportLine> scanReportLines(const AcquireResult& result);

}  // namespace mien
