#pragma once

#include <vtkNew.h>

#include <array>
#include <string>
#include <vector>

#include "ContinuityFigure.h"
#include "FaceSurface.h"
#include "PipelineErrors.h"

class vtkPatchContinuityFilter;
class vtkPolyData;
class vtkTable;

namespace mien {

/// The seams of the face in one scheme, as a dock reads them from vtkPatchContinuityFilter.
class SchemeContinuity {
 public:
  SchemeContinuity();
  ~SchemeContinuity();

  /// @return nothing, or why there is no surface
  std::string measure(vtkPolyData* curves, const FaceSurfaceOptions& options);

  bool isValid() const { return valid_; }
  const std::string& scheme() const { return scheme_; }
  vtkTable* summary() const;
  vtkPolyData* seams() const;
  std::vector<std::string> seamNames() const;

  /// A point array along one seam.
  SeamProfile profile(int seam, const std::string& array) const;

  /// The point of a seam next to v (degrees), mm.
  std::array<double, 3> pointAt(int seam, double v) const;

  /// The box around a seam's part on the front of the face, or around all of it when it has none: x, y, z from and to,
  /// mm.
  std::array<double, 6> box(int seam) const;

 private:
  int samples() const;

  vtkNew<vtkPatchContinuityFilter> filter_;
  PipelineErrors errors_;
  std::string scheme_;
  bool valid_ = false;
};

}  // namespace mien
