/**
 * @class vtkPDEParameterSweep
 * @brief measures of a PDE face over many values of the smoothing parameter a, as a table
 *
 * Inputs: port 0 vtkPolyData, the boundary curves of BoundaryCurveData.h (29 curves of K points, mm); port 1, optional,
 * a reference mesh (vtkPolyData or vtkStructuredGrid, mm). Output: vtkTable, one row per scheme and a, scheme after
 * scheme, columns (double but for the texts)
 * - `scheme` (text), `a` (no unit);
 * - `area_mm2`: the integral of |S_u x S_v|;
 * - `rms_departure_mm`, `max_departure_mm`: from the surface of the same scheme at ReferenceSmoothing, at the same (u,
 * v);
 * - `curve_miss_rms_mm`: between the curves' samples and the surface at the same (u, v);
 * - `lebesgue`: how much the surface can exceed its curves (FaceLebesgue.h);
 * - `g1_max_deg`: the largest angle between normals across a seam, at the grid's columns;
 * - `folded_cells`, `folded_cells_on_seams`: cells with z > 50 mm turned against a neighbour by more than 90 degrees;
 * - `turned_area_share`: of the front, whose normal is turned by more than 90 degrees against the same scheme at a =
 * 0.1;
 * - `willmore_energy`: the integral of the squared mean curvature (no unit);
 * - `box_ratio`: how much the curves' bounding box must grow to hold the surface;
 * - `distance_rms_mm`, with a reference only: from the surface's part with z > 50 mm to the reference, area-weighted;
 * - `reason` (text): why a scheme has no surface at this a, whose measures are then NaN; empty otherwise.
 *
 * The measures are those of filters/core; Scheme and Smoothing of the base class only matter where no lists are given.
 * Abort and progress are honoured after every surface; an aborted sweep leaves an empty table.
 * Errors: curves that are no face, a scheme that does not exist, values outside 0 < a <= 1000, a reference without
 * polygons.
 */
#ifndef vtkPDEParameterSweep_h
#define vtkPDEParameterSweep_h

#include "MienSurfaceModule.h"
#include "vtkPDEFaceAlgorithm.h"

class vtkTable;

namespace mien {
struct FaceCurves;
struct SmoothingSweepOptions;
struct SweepRecord;
}  // namespace mien

class MIENSURFACE_EXPORT vtkPDEParameterSweep : public vtkPDEFaceAlgorithm {
 public:
  static vtkPDEParameterSweep* New();
  vtkTypeMacro(vtkPDEParameterSweep, vtkPDEFaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkTable* GetOutput();  ///< a row per scheme and a

  ///@{
  /** The mesh to measure distances to (port 1). Default: none. */
  void SetReferenceConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetReferenceData(vtkDataObject* reference) { this->SetInputDataInternal(1, reference); }
  ///@}

  ///@{
  /** The schemes to sweep, as GetSchemeNames() lists them. Default: none, which takes GetScheme(). */
  void AddScheme(const std::string& name);
  void AddAllSchemes();
  void ClearSchemes();
  std::vector<std::string> GetSchemes() const { return this->Schemes; }
  ///@}

  ///@{
  /** The values of a, no unit, each 0 < a <= 1000; as numbers or as text such as "0.1:100:50log", "0.1:1:10" or
   * "1,2,5". Text that cannot be read is an error and changes nothing. Default: 0.1:10:21log. */
  void SetSmoothingValues(const std::vector<double>& values);
  void SetSmoothingRange(const std::string& text);
  std::vector<double> GetSmoothingValues() const { return this->SmoothingValues; }
  ///@}

  ///@{
  /** The a from whose surface departures are measured. Default 1; 0 < a <= 1000. */
  vtkSetMacro(ReferenceSmoothing, double);
  vtkGetMacro(ReferenceSmoothing, double);
  ///@}

  ///@{
  /** Rows and columns of the grid on which is measured, as in vtkPDEFaceFilter. Default 112 x 80; 11 x 3 .. 4096 x
   * 4096. */
  void SetResolution(int rows, int columns);
  vtkGetMacro(NumberOfRows, int);
  vtkGetMacro(NumberOfColumns, int);
  ///@}

  ///@{
  /** Threads to use; the numbers do not depend on it. Default 0: as many as VTK uses. */
  vtkSetClampMacro(NumberOfThreads, int, 0, 256);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  /** The a from which on a scheme of the last update is no face any more (SweepBreakdown.h), to 1 percent whatever the
   * resolution and the values swept (BreakdownSearch.h), or NaN if it held. */
  double GetBreakdown(const std::string& scheme) const;
  /** What happens there, one sentence; empty if it held. */
  std::string GetBreakdownReason(const std::string& scheme) const;

 protected:
  vtkPDEParameterSweep();
  ~vtkPDEParameterSweep() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  vtkPDEParameterSweep(const vtkPDEParameterSweep&) = delete;
  void operator=(const vtkPDEParameterSweep&) = delete;

  mien::SmoothingSweepOptions MakeSweep() const;
  void FindBreakdowns(const mien::FaceCurves& face, const mien::SmoothingSweepOptions& sweep,
                      const std::vector<mien::SweepRecord>& records);
  int Refuse(const std::string& fault);

  struct Internals;
  std::unique_ptr<Internals> Impl;
  std::vector<std::string> Schemes;
  std::vector<double> SmoothingValues;
  double ReferenceSmoothing = 1.0;
  int NumberOfRows = 112;
  int NumberOfColumns = 80;
  int NumberOfThreads = 0;
};

#endif
