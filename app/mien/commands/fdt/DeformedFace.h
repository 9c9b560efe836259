#pragma once

#include <string>

#include "DeformationTable.h"
#include "MarkerFileOptions.h"
#include "vtkSmartPointer.h"

class vtkPointSet;

namespace mien {

/// How a table moves a face.
struct DeformationOptions {
  MarkerFileOptions reading;
  std::string landmarks;  ///< file of 68 landmarks, or empty
  double strength = 1.0;
  bool hard = false;  ///< nearest region alone
};

/// Moves the markers that were seen; pupils stay. What is wrong is a FileFailure that names `file`.
void deformMarkers(PointTable& markers, const DeformationTable& table, const DeformationOptions& options,
                   const std::string& file);

/// A copy of the surface with moved points and the point array `Displacement` (vtkFDTDeformationFilter). Says on stderr
/// when nothing tells its lips apart.
vtkSmartPointer<vtkPointSet> deformSurface(vtkPointSet* surface, const DeformationTable& table,
                                           const DeformationOptions& options, const std::string& file);

}  // namespace mien
