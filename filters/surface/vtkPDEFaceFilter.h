/**
 * @class vtkPDEFaceFilter
 * @brief the PDE face: nine spectral patches between 29 boundary curves, as one structured grid
 *
 * Input: vtkPolyData, the boundary curves of BoundaryCurveData.h (29 curves of K points, mm).
 * Output: vtkStructuredGrid of (NumberOfColumns + 1) x NumberOfRows points, v fastest, the last column
 * repeating the first. Point arrays `Normals` (unit, outwards, from analytic derivatives),
 * `TextureCoordinates` (v / 2 pi, 1 - u over the whole face), optionally `Su`, `Sv` (mm); cell array
 * `PatchId` (0 .. 8). Cells between C22 and C22' are blanked between the mouth corners only.
 * VTK winds these cells inwards. Give the grid to mappers, writers and locators through vtkGeometryFilter.
 *
 * Equation: (d2/du2 + a^2 d2/dv2)^m S = 0 per patch, Fourier modes 0 .. N and one remainder
 * [Sheng et al. 2011, eq. 1-11]. Honours update extents and pieces; runs through vtkSMPTools.
 * Errors: curves that are no face, options out of range, a(N + 1) past what the scheme bears.
 */
#ifndef vtkPDEFaceFilter_h
#define vtkPDEFaceFilter_h

#include "MienSurfaceModule.h"
#include "vtkStructuredGridAlgorithm.h"

#include <memory>
#include <string>
#include <vector>

class MIENSURFACE_EXPORT vtkPDEFaceFilter : public vtkStructuredGridAlgorithm
{
public:
  static vtkPDEFaceFilter* New();
  vtkTypeMacro(vtkPDEFaceFilter, vtkStructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** How patches meet their curves: "spline" (default), "four-curve" (the paper's), "derivative", "sixth-order",
   *  "tangent", "curvature"; GetSchemeNames() lists them. */
  void SetScheme(const std::string& name);
  std::string GetScheme() const;
  static std::vector<std::string> GetSchemeNames();
  ///@}

  ///@{
  /** The smoothing parameter a, for all patches or for one (0 .. 8). No unit; default 1, 0 < a <= 1000. */
  void SetSmoothing(double a);
  void SetSmoothing(int patch, double a);
  double GetSmoothing(int patch) const;
  ///@}

  ///@{
  /** N: how many Fourier modes are solved exactly. Default 5; 0 .. K / 2. */
  vtkSetMacro(NumberOfModes, int);
  vtkGetMacro(NumberOfModes, int);
  ///@}

  ///@{
  /** Whether all harmonics above N follow as one remainder, so that curves are met. Default on. */
  vtkSetMacro(Remainder, bool);
  vtkGetMacro(Remainder, bool);
  vtkBooleanMacro(Remainder, bool);
  ///@}

  ///@{
  /** Rows (u, both lip rows counted) and columns (v, without the closing one). Default 56 x 40; rows 11 ..,
   *  columns 3 .. */
  void SetResolution(int rows, int columns);
  vtkGetMacro(NumberOfRows, int);
  vtkGetMacro(NumberOfColumns, int);
  ///@}

  ///@{
  /** Rows at equal u over the whole face as in the paper instead of dealt evenly to the intervals between
   *  curves. Default off. */
  vtkSetMacro(UniformRows, bool);
  vtkGetMacro(UniformRows, bool);
  vtkBooleanMacro(UniformRows, bool);
  ///@}

  ///@{
  /** Factor on the derivative conditions of schemes that have them [S 3.3]. Default 1; any finite number. */
  vtkSetMacro(DerivativeStrength, double);
  vtkGetMacro(DerivativeStrength, double);
  ///@}

  ///@{
  /** Whether `Su` and `Sv` are added. Default off. */
  vtkSetMacro(GenerateDerivatives, bool);
  vtkGetMacro(GenerateDerivatives, bool);
  vtkBooleanMacro(GenerateDerivatives, bool);
  ///@}

  ///@{
  /** vtkAlgorithm::SINGLE_PRECISION (default) or DOUBLE_PRECISION, for points and arrays. */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DOUBLE_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

protected:
  vtkPDEFaceFilter();
  ~vtkPDEFaceFilter() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPDEFaceFilter(const vtkPDEFaceFilter&) = delete;
  void operator=(const vtkPDEFaceFilter&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Impl;
  int NumberOfModes = 5;
  bool Remainder = true;
  int NumberOfRows = 56;
  int NumberOfColumns = 40;
  bool UniformRows = false;
  double DerivativeStrength = 1.0;
  bool GenerateDerivatives = false;
  int OutputPointsPrecision = SINGLE_PRECISION;
};

#endif
