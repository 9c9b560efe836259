#pragma once

#include <QPolygonF>
#include <vector>

#include "DeformationTable.h"
#include "FacialRegions.h"
#include "Plate.h"

namespace mien {

/// Where a table takes a point of a face, pupil units.
struct DeformationArrow {
  QPointF at, move;
};

/// What the figure of a table shows besides the table.
struct DeformationFigureOptions {
  std::vector<QPolygonF> faceLines;      ///< of a face, pupil units, drawn behind the regions
  std::vector<QPolygonF> featureLines;   ///< brows, lids, nose and lips, by which it is recognised
  std::vector<DeformationArrow> arrows;  ///< of the same face, as the table moves it
  bool hard = false;                     ///< whether the arrows are those of hard regions
  double magnification = 1.0;            ///< of the arrows
  double pupilUnit = 0.0;                ///< of the face, mm; 0: not known
  bool coefficients = true;              ///< whether the coefficients are set below
};

/// The distance between arrows that suits a figure of that width (mm), pupil units.
double arrowSpacing(double width);

/// The 16 regions on the face with their numbers, the displacements of points of the face with a reference arrow, and
/// the coefficients, with their standard deviations where the table has them. All arrows lie within their panel.
///
/// @param width  of the figure, mm
Plate deformationPlate(const DeformationTable& table, const FacialRegions& regions,
                       const DeformationFigureOptions& options, double width);

}  // namespace mien
