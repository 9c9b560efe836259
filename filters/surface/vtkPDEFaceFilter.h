/**
 * @class vtkPDEFaceFilter
 * @brief the PDE face: nine spectral patches between 29 boundary curves, as one structured grid
 *
 * Input: vtkPolyData, the boundary curves of BoundaryCurveData.h (29 curves of K points, mm).
 * Output: vtkStructuredGrid of (NumberOfColumns + 1) x NumberOfRows points, v fastest, the last column
 * repeating the first. Point arrays `Normals` (unit, outwards, from analytic derivatives),
 * `TextureCoordinates` (v / 2 pi, 1 - u over the whole face), optionally `Su`, `Sv` (mm) and the curvatures; cell array
 * `PatchId` (0 .. 8); field arrays `Pupils` and `HeadRotation` of the curves where they have them. Cells between C22
 * and C22' are blanked between the mouth corners only. VTK winds these cells inwards. Give the grid to mappers, writers
 * and locators through vtkGeometryFilter.
 *
 * Equation: (d2/du2 + a^2 d2/dv2)^m S = 0 per patch, Fourier modes 0 .. N and one remainder
 * [Sheng et al. 2011, eq. 1-11]. Honours update extents and pieces; runs through vtkSMPTools. Patches whose curves are
 * as before are left as they are in an array that is written again: whoever writes into the output calls the array's
 * Modified().
 * Errors: those of vtkPDEFaceAlgorithm, and a resolution that is too coarse or too fine.
 */
#ifndef vtkPDEFaceFilter_h
#define vtkPDEFaceFilter_h

#include "MienSurfaceModule.h"
#include "vtkPDEFaceAlgorithm.h"

class vtkStructuredGrid;

namespace mien {
class RowLayout;
struct SurfaceGridLayout;
}  // namespace mien

class MIENSURFACE_EXPORT vtkPDEFaceFilter : public vtkPDEFaceAlgorithm {
 public:
  static vtkPDEFaceFilter* New();
  vtkTypeMacro(vtkPDEFaceFilter, vtkPDEFaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The surface.
  vtkStructuredGrid* GetOutput();

  ///@{
  /** Rows (u, both lip rows counted) and columns (v, without the closing one). Default 56 x 40; rows 11 ..
   *  100000, columns 3 .. 100000, at most 134217728 points in a part that is asked for. */
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
  /** Whether `Su` and `Sv` are added. Default off. */
  vtkSetMacro(GenerateDerivatives, bool);
  vtkGetMacro(GenerateDerivatives, bool);
  vtkBooleanMacro(GenerateDerivatives, bool);
  ///@}

  ///@{
  /** Whether `MeanCurvature`, `MaximumCurvature`, `MinimumCurvature` (the principal ones, 1/mm) and `GaussianCurvature`
   * (1/mm^2) are added, from analytic second derivatives. A sphere of radius R seen from outside has the mean curvature
   * +1 / R. NaN where the surface has no tangent plane; a seam's row belongs to the patch above. Default off. */
  vtkSetMacro(GenerateCurvatures, bool);
  vtkGetMacro(GenerateCurvatures, bool);
  vtkBooleanMacro(GenerateCurvatures, bool);
  ///@}

  ///@{
  /** vtkAlgorithm::SINGLE_PRECISION (default) or DOUBLE_PRECISION, for points and arrays. */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DOUBLE_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

 protected:
  vtkPDEFaceFilter();
  ~vtkPDEFaceFilter() override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// False, after an error, when the resolution is too coarse or too fine.
  bool CheckResolution();

  /// Whether only the part that is asked for is computed, so that the whole may be larger than memory. Default true.
  virtual bool IsMadeInParts() const { return true; }

  /// Writes the surface that `options` make of the curves into the part of the grid that is wanted on port 0; leaves it
  /// empty when aborted. False, after an error, when the conditions determine no surface.
  bool MakeSurface(const mien::FaceCurves& face, const mien::FaceSurfaceOptions& options,
                   vtkInformationVector* outputs);

 private:
  vtkPDEFaceFilter(const vtkPDEFaceFilter&) = delete;
  void operator=(const vtkPDEFaceFilter&) = delete;

  std::string FillGrid(const mien::FaceCurves& face, const mien::FaceSurfaceOptions& options,
                       const mien::RowLayout& rows, const mien::SurfaceGridLayout& layout, vtkStructuredGrid* output);

  struct Internals;
  std::unique_ptr<Internals> Impl;
  int NumberOfRows = 56;
  int NumberOfColumns = 40;
  bool UniformRows = false;
  bool GenerateDerivatives = false;
  bool GenerateCurvatures = false;
  int OutputPointsPrecision = SINGLE_PRECISION;
};

#endif
