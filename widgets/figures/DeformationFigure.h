#pragma once

#include <QPolygonF>
#include <vector>

#include "DeformationTable.h"
#include "FacialRegions.h"
#include "Plate.h"

namespace mien {

/// What the figure of a table shows besides the table.
struct DeformationFigureOptions {
  std::vector<QPolygonF> faceLines;  ///< of a face, pupil units, drawn behind the regions
  double magnification = 2.0;        ///< of the arrows
  double spacing = 0.3;              ///< of the arrows, pupil units
  bool coefficients = true;          ///< whether the coefficients are set below
};

/// The 16 regions on the face with their numbers, the displacement each map gives to the points of its region, and the
/// coefficients, with their standard deviations where the table has them.
///
/// @param width  of the figure, mm
Plate deformationPlate(const DeformationTable& table, const FacialRegions& regions,
                       const DeformationFigureOptions& options, double width);

}  // namespace mien
