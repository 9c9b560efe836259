#pragma once

#include <QString>
#include <vector>

#include "FAPTable.h"

namespace mien {

/// The name of a FAP for people: raise_l_i_eyebrow becomes "Raise left inner eyebrow".
QString fapLabel(const FAPDefinition& fap);

/// Groups of the standard that have low-level FAPs, from the top of the face down; those without surface last.
const std::vector<int>& fapGroups();

/// The feature of such a group, for people: "Jaw and inner lips".
QString fapGroupTitle(int group);

/// Whether each of these words is part of the FAP's name in the standard or here, or its number or feature point.
bool fapMatches(const FAPDefinition& fap, const QString& words);

/// Number, standard name, feature point, what a positive value does, and the unit with its length on this face.
/// @param millimetresPerUnit 0 for an angle
QString fapToolTip(const FAPDefinition& fap, double millimetresPerUnit);

}  // namespace mien
