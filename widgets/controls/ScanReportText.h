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

/// Mesh with its unit, pose and whether the faces wind inwards, landmarks and whether larger parts than theirs were
/// left out, distance, crossings: as many lines for every scan, so that all have room.
std::vector<ScanReportLine> scanReportLines(const AcquireResult& result);

}  // namespace mien
