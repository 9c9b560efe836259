#pragma once

#include <map>

#include "Figure.h"
#include "SmoothingSweep.h"

namespace mien {

/// Small multiples of a sweep's measures over a: a panel per measure, a line per scheme.
///
/// @param breakdowns  scheme to the a from which on its surface is no face
/// @param reference   the a that departures are taken from
Figure sweepFigure(const std::vector<SweepRecord>& records, const std::map<std::string, double>& breakdowns,
                   double reference);

/// The title of a panel's axis of a, which says why the axis ends before the data where it does: for a panel that
/// stands without the caption.
std::string sweepAxisTitle(const Chart& panel);

}  // namespace mien
