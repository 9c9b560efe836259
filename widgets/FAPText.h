#pragma once

#include "FAPTable.h"

#include <QString>

namespace mien {

/// The name of a FAP for people: raise_l_i_eyebrow becomes "Raise left inner eyebrow".
QString fapLabel(const FAPDefinition& fap);

/// Number, standard name, what a positive value does, and the unit with its length on this face.
/// @param millimetresPerUnit 0 for an angle
QString fapToolTip(const FAPDefinition& fap, double millimetresPerUnit);

}  // namespace mien
