#pragma once

#include "Figure.h"

namespace mien {

/// A level of detail of a head and how far it lies from the scan.
struct DetailPoint {
  std::string representation;  ///< one series each, in the order of their first points
  double bytes = 0.0;
  double rms = 0.0;      ///< the larger of both ways, mm
  double largest = 0.0;  ///< Hausdorff distance, mm
};

/// Bytes against error, each on a logarithmic axis; a level without a distance, such as the scan itself, is left out.
///
/// @param curveBytes  of all points of the curves, where the figure has a mark
/// @param reference  what distances are measured to, in words
Figure detailFigure(const std::vector<DetailPoint>& points, double curveBytes,
                    const std::string& reference = "the scan");

}  // namespace mien
