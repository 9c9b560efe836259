/**
 * @class vtkPatchContinuityFilter
 * @brief how smoothly the nine patches of a PDE face meet: the eight seams, measured from both sides
 *
 * Input: vtkPolyData, the boundary curves of BoundaryCurveData.h (29 curves of K points, mm).
 * Output 0: vtkPolyData, one closed polyline per seam on the surface, NumberOfSamples points each (the last id repeats
 * the first; between parted lips it runs midway). Point arrays `G0` (gap, mm), `G1` (angle between the normals,
 * degrees), `C1` (jump of S_u relative to its mean), `G2` (difference of the normal curvatures perpendicular to the
 * seam, 1/mm), `C2` (jump of S_uu relative to its mean), `V` (radians); cell array `SeamName` ("P0|P1" .. "P7|P8").
 * Pieces share the seams out. Output 1: vtkTable, one row per seam and a last one, "all", over all of them. Columns
 * `seam`, `g0_max_mm`, `g1_mean_deg`, `g1_max_deg`, `c1_max`, `g2_max_per_mm`, `c2_max`, and with the prefix `frontal_`
 * the same over samples with z > 50 mm. Every sample weighs the same. NaN stands for what is nowhere defined, such as
 * the frontal part of a seam that has none.
 *
 * Equation: one-sided jets S, S_u, S_v, S_uu, S_uv, S_vv of the patches' own solutions; nothing is differenced.
 * Errors: those of vtkPDEFaceAlgorithm, and a number of samples out of range.
 * @sa vtkPDEFaceFilter
 */
#ifndef vtkPatchContinuityFilter_h
#define vtkPatchContinuityFilter_h

#include "MienSurfaceModule.h"
#include "vtkPDEFaceAlgorithm.h"

class vtkPolyData;
class vtkTable;

class MIENSURFACE_EXPORT vtkPatchContinuityFilter : public vtkPDEFaceAlgorithm {
 public:
  static vtkPatchContinuityFilter* New();
  vtkTypeMacro(vtkPatchContinuityFilter, vtkPDEFaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The seams.
  vtkPolyData* GetOutput();

  /// The summary.
  vtkTable* GetSummary();

  ///@{
  /** Samples per seam, equidistant in v. Default 400; 3 .. 20000. */
  vtkSetMacro(NumberOfSamples, int);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

 protected:
  vtkPatchContinuityFilter();
  ~vtkPatchContinuityFilter() override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  vtkPatchContinuityFilter(const vtkPatchContinuityFilter&) = delete;
  void operator=(const vtkPatchContinuityFilter&) = delete;

  bool CheckSamples();

  struct Internals;
  std::unique_ptr<Internals> Impl;
  int NumberOfSamples = 400;
};

#endif
