#pragma once

#include <string>

#include "DeformationTable.h"

namespace mien {

/// Reads a facial deformation table: CSV with a header naming `region` and `a1` .. `a6`, `b1` .. `b6`, optionally
/// `a1_sd` .. `b6_sd` (all or none), `n` (of recordings that a region's map rests on; 0: none, it is not known) and
/// `displacement` (largest of the points it was fitted to, pupil units; the largest row counts), in any order; a row
/// for each of the 16 regions. Lines that begin with # are comments.
/// @return nothing, or "LINE: what is wrong and what to do"; the table is then as it was
std::string parseTable(const std::string& text, DeformationTable& table);

/// The text that parseTable reads back without a difference. `comment` may have several lines.
std::string writeTable(const DeformationTable& table, const std::string& comment = {});

}  // namespace mien
