#pragma once

#include <string>
#include <vector>

#include "AnimationTable.h"
#include "ClosedCurves.h"
#include "ExpressionLibrary.h"
#include "FacialActionMap.h"
#include "MienAnimationModule.h"
#include "vtkType.h"

class vtkPolyData;

namespace mien {

/// Reads an animation table from a file, or the one compiled in when the name is empty.
/// @return nothing, or one sentence that names the file, the entry and what is wrong
MIENANIMATION_EXPORT std::string readAnimationTable(const std::string& fileName, AnimationTable& table);

/// Reads what action units and blendshapes move from a file, or takes what is compiled in when the name is empty.
/// @return nothing, or one sentence that names the file, the entry and what is wrong
MIENANIMATION_EXPORT std::string readFacialActions(const std::string& fileName, FacialActionMap& map);

/// The expressions compiled in.
MIENANIMATION_EXPORT const ExpressionLibrary& defaultExpressions();

/// What action units and blendshapes move, compiled in.
MIENANIMATION_EXPORT const FacialActionMap& defaultFacialActions();

/// The visemes compiled in, 1 .. 14.
MIENANIMATION_EXPORT const ExpressionLibrary& defaultVisemes();

/// Writes curves that moved as a copy of the data they were read from (readFaceCurves), with all its arrays and
/// the point array `Displacement` (mm); lines that shared a point get one each.
void writeMovedCurves(const ClosedCurves& neutral, const ClosedCurves& moved, vtkPolyData* curves, vtkPolyData* output);

}  // namespace mien
