#pragma once

#include <string>
#include <vector>

#include "DeformationTable.h"
#include "MienDeformationModule.h"

namespace mien {

/// Names of the tables that are compiled in: anger, disgust, fear, joy, sadness, surprise (means of data/deformation)
/// and smile (Table I of Obaid et al. 2009).
MIENDEFORMATION_EXPORT const std::vector<std::string>& tableNames();

/// The compiled in table of a name, or nothing.
MIENDEFORMATION_EXPORT const DeformationTable* namedTable(const std::string& name);

/// A table by its compiled in name or from a file, as text (TableText.h) or packed (PackedTable.h); the sum of several
/// with weights (TableList.h), "joy:0.5,fear:0.5"; or the text of a table itself.
/// @return nothing, or one sentence that names file and line
MIENDEFORMATION_EXPORT std::string readNamedTable(const std::string& nameOrFile, DeformationTable& table);

}  // namespace mien
