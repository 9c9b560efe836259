#pragma once

#include <string>

#include "FaceCurves.h"
#include "HeadRotation.h"
#include "MienSurfaceModule.h"

class vtkFieldData;
class vtkPolyData;

/// Boundary curves as VTK data and as the mathematics sees them.
///
/// As vtkPolyData: 29 closed polylines (K + 1 point ids, the last repeating the first), K points each,
/// stored curve after curve in the order C1 .. C22, C22', C23 .. C28; cell arrays `CurveId` (1 .. 28 and
/// 29 for C22') and `CurveName`; field arrays `Units` = "mm", `FeatureId` (string), `FeatureCurve` (the
/// CurveId the feature lies on), `FeatureV` (radians) and `Pupils` (2 x 3, left then right, mm); on a turned head
/// `HeadRotation` (1 x 12: rotation row by row, then its centre in mm), in whose frame the curves run down the face.
namespace mien {

/// Reads any closed polylines with equal point counts; points in the order of the lines.
/// @return nothing, or one sentence that says what is wrong and where
MIENSURFACE_EXPORT std::string readClosedCurves(vtkPolyData* data, ClosedCurves& curves);

/// Reads a face: 29 curves in any order told by `CurveId` (in file order without that array), features, pupils.
/// @return nothing, or one sentence that says what is wrong and where
MIENSURFACE_EXPORT std::string readFaceCurves(vtkPolyData* data, FaceCurves& face);

/// The rotation that animation gave the head; nothing changes without the array.
/// @return nothing, or one sentence that says what is wrong
MIENSURFACE_EXPORT std::string readHeadRotation(vtkFieldData* fields, HeadRotation& turned);
MIENSURFACE_EXPORT void writeHeadRotation(const HeadRotation& turned, vtkFieldData* fields);  ///< as read

/// Writes closed polylines without any arrays.
MIENSURFACE_EXPORT void writeClosedCurves(const ClosedCurves& curves, vtkPolyData* data);

/// Writes a face with all the arrays named above.
MIENSURFACE_EXPORT void writeFaceCurves(const FaceCurves& face, vtkPolyData* data);

}  // namespace mien
