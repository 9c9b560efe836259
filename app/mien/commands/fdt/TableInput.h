#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "DeformationTable.h"
#include "FittedTable.h"
#include "MarkerFileOptions.h"

namespace mien {

/// A table by its compiled in name or from a file; a FileFailure for one that is none.
DeformationTable readTable(const std::string& nameOrFile);

/// Tables with weights, TABLE[:WEIGHT] each, weights -2 .. 2: the sum of their displacements.
DeformationTable readWeightedTables(const std::vector<std::string>& texts);

/// What a command takes that accepts recordings in place of tables.
struct TableInput {
  std::string name;                    ///< as given
  std::optional<MarkerTable> markers;  ///< of a recording
  DeformationTable table;              ///< as read, or fitted to the recording
  double rms = 0.0;                    ///< of that fit, pupil units
};

/// Recordings are told by the column `marker`. Sparse regions of a fit are reported on stderr. A FileFailure for a file
/// that is neither.
TableInput readTableOrRecording(const std::string& nameOrFile, const MarkerFileOptions& options,
                                const FacialRegions& regions);

/// One sentence that names the regions a table does not know, or nothing.
std::string describeUnknown(const DeformationTable& table);

/// The name of a table for reading: that of the file without folder and ending.
std::string shortTableName(const std::string& nameOrFile);

}  // namespace mien
