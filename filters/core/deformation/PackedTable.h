#pragma once

#include <string>

#include "FacialRegions.h"

namespace mien {

/// A table in fixed point: 220 bytes at 8 bits a coefficient, 412 at 16, against 1,536 as doubles. Deviations are left
/// out.
///
/// Version 2, little endian: the bytes `MFDT`, version (2), bits (8 or 16), two bytes 0 (of version 3, written where it
/// has any: a bit for each region, the first the lowest, whose map is not known), then as 32-bit floats the largest
/// fitted displacement (0: not known) and the steps of the quadratic, linear and constant coefficients; then region by
/// region the integers of x' - x (x^2, xy, y^2, x, y, 1) and y' - y about the region's centre in
/// data/deformation/regions.json, version 1. About its centre a region's coefficients are small, and so are the steps.
/// Last the CRC-32 of all bytes before it, which version 1 has not. `bits` is 8 or 16; the table can be packed
/// (describePacking).
std::string packTable(const DeformationTable& table, int bits);

/// What keeps a table from being packed (coefficients or a displacement that no file may hold), or nothing.
std::string describePacking(const DeformationTable& table, int bits);

/// Whether bytes begin as a packed table does.
bool isPackedTable(const std::string& bytes);

/// @return nothing, or one sentence that says what is wrong; the table is then as it was
std::string unpackTable(const std::string& bytes, DeformationTable& table);

/// How far a point within `reach` of its region's centre can be displaced otherwise than by the table itself, pupil
/// units: half a step of each coefficient times the largest value of its term.
double packingError(const DeformationTable& table, int bits, double reach);

/// The same for any point of a face that is deformed smoothly: over the face's outline, with the maps' weights there
/// and on either side of the lips, which reach further from the centres than the regions do.
double packingError(const DeformationTable& table, int bits, const FacialRegions& regions);

}  // namespace mien
