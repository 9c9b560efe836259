#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ClosedCurves.h"
#include "HarmonicSplit.h"
#include "SurfacePiece.h"

class vtkAlgorithm;
class vtkStructuredGrid;

namespace mien {

/// What a uv mesh carries beside its geometry, and which part of it is wanted.
struct SurfaceGridLayout {
  std::vector<double> faceU;      ///< per row, 0 .. 1 down the whole surface
  std::vector<int> patchOfCells;  ///< per row of cells
  int columns = 0;                ///< without the closing one
  int slitRow = -1;               ///< row of cells that is open, or -1
  double slitBegin = 0.0;         ///< v between which it is open, radians
  double slitEnd = 0.0;
  bool curvatures = false;  ///< `MeanCurvature`, `GaussianCurvature`, `MaximumCurvature`, `MinimumCurvature`
  int extent[6] = {0, -1, 0, -1, 0, 0};  ///< wanted: columns, rows

  bool operator==(const SurfaceGridLayout& other) const;
};

/// A PDE surface as a structured grid, kept between updates: only the curves change.
class SurfaceGrid {
 public:
  virtual ~SurfaceGrid() = default;

  /// @param doublePrecision  of points and arrays
  static std::unique_ptr<SurfaceGrid> make(const std::vector<SurfacePiece>& pieces, const HarmonicSplit& split,
                                           int curveCount, const SurfaceGridLayout& layout, bool doublePrecision);

  /// One sentence when the pieces determine no surface.
  virtual std::string fault() const = 0;

  /// Fills the output; reports progress to the algorithm and leaves the output empty when it is aborted.
  virtual void execute(const ClosedCurves& curves, bool derivatives, vtkAlgorithm* self, vtkStructuredGrid* output) = 0;
};

}  // namespace mien
