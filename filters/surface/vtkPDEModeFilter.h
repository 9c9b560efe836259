/**
 * @class vtkPDEModeFilter
 * @brief what each Fourier mode, and the remainder beside them, contributes to a PDE face
 *
 * Input: vtkPolyData, the boundary curves of BoundaryCurveData.h (29 curves of K points, mm).
 * Output 0: vtkStructuredGrid as vtkPDEFaceFilter's, of the whole surface or of a partial sum, with the point array
 * `Contribution` (3 components, mm): S_n(u, v) of the chosen mode. The contributions of all modes and of the remainder
 * sum to the surface, so that of mode 0 carries its place. Output 1: vtkTable, one row per mode and one for the
 * remainder. Columns `mode` ("0" .. or "remainder"), `rms_mm`, `max_mm`, `energy_share` (they sum to 1),
 * `cumulative_rms_error_mm` (what the sum up to this row still lacks of the surface). RMS values are over u and v, not
 * over area: exact in v by Parseval's theorem, trapezoidal in u over the rows; the maximum is over the grid's points.
 * Mode 0 is measured from the surface's centroid, or the origin would decide. The table is that of the whole grid,
 * in piece 0 of what is wanted.
 *
 * Equation: S = sum over j of U_j(u) B_j(v) [Sheng et al. 2011, eq. 9-11].
 * Errors: those of vtkPDEFaceFilter, and a mode that the surface does not have.
 * @sa vtkPDEFaceFilter
 */
#ifndef vtkPDEModeFilter_h
#define vtkPDEModeFilter_h

#include "MienSurfaceModule.h"
#include "vtkPDEFaceFilter.h"

class vtkTable;

class MIENSURFACE_EXPORT vtkPDEModeFilter : public vtkPDEFaceFilter {
 public:
  static vtkPDEModeFilter* New();
  vtkTypeMacro(vtkPDEModeFilter, vtkPDEFaceFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The measures of all modes.
  vtkTable* GetSpectrum();

  ///@{
  /** The mode whose contribution is shown, 0 .. NumberOfModes, or -1 for the remainder. Default 0. */
  vtkSetMacro(Mode, int);
  vtkGetMacro(Mode, int);
  ///@}

  ///@{
  /** Whether the grid is the sum of the modes up to the chosen one instead of the whole surface; with the remainder
   * chosen both are the same. Default off. */
  vtkSetMacro(PartialSum, bool);
  vtkGetMacro(PartialSum, bool);
  vtkBooleanMacro(PartialSum, bool);
  ///@}

  /** The smallest N with which modes 0 .. N alone, without a remainder, come as near to the surface of all K / 2 modes
   * as `tolerance` (mm, RMS over u and v, at least 0). Brings the input up to date; all other parameters as set,
   * NumberOfModes aside. -1 after an error. */
  int FindNumberOfModes(double tolerance);

 protected:
  vtkPDEModeFilter();
  ~vtkPDEModeFilter() override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  bool IsMadeInParts() const override { return false; }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  vtkPDEModeFilter(const vtkPDEModeFilter&) = delete;
  void operator=(const vtkPDEModeFilter&) = delete;

  bool CheckMode();

  struct Internals;
  std::unique_ptr<Internals> Impl;
  int Mode = 0;
  bool PartialSum = false;
};

#endif
