/**
 * @class vtkLevelOfDetailFilter
 * @brief bytes against error: a head as a PDE face, as its modes, as compact faces and as decimated meshes
 *
 * Inputs: port 0 vtkPolyData, the boundary curves of a head (BoundaryCurveData.h, 29 curves of K points, mm); port 1
 * vtkPolyData, the scan they were measured on, in the same frame (mm). Output: vtkTable, one row per level, columns
 * - `representation`: "scan", "PDE face" (29 K points), "modes" (the first N Fourier modes of the curves), "compact
 * face" (.mienz, CompactFace.h), "decimated mesh" (OpenMesh's quadric module) and "packed mesh" (the same, rounded and
 * packed: MeshCode.h); `detail`;
 * - `bytes`: coordinates as single precision numbers; a mesh has three per vertex and three 16 bit indices per triangle
 * (32 bit beyond 65,536 vertices); compact faces and packed meshes as packed;
 * - `triangles`: of meshes, 0 for curves;
 * - `rms_mm`, `max_mm`: from the level's surface to the scan; `back_rms_mm`, `back_max_mm`: from the scan to it;
 * `symmetric_rms_mm`, `hausdorff_mm`: the larger of both ways;
 * - `curves_rms_mm`: between the curves' points and those of port 0; NaN for meshes.
 *
 * All are measured alike: at points 2 mm apart spread evenly over the surfaces, weighted with area, where z is beyond
 * FrontalThreshold and between the first and the last curve, 4 mm inside them. From the scan only its outer skin
 * counts, as seen from the axis of the head. Meshes are made from the part of the scan between the first and last
 * curve, all around the head, which is what the face covers, and get as many triangles as fit into the bytes of each
 * face. Faces use the surface parameters of the base class. Tells its progress and can be aborted, which leaves an
 * empty table. Errors: curves that are no face, parameters out of range, a scan without triangles or without skin where
 * the face is.
 * @sa vtkCompactFaceWriter vtkSurfaceDistanceFilter
 */
#ifndef vtkLevelOfDetailFilter_h
#define vtkLevelOfDetailFilter_h

#include "MienAcquisitionModule.h"
#include "vtkPDEFaceAlgorithm.h"

class vtkTable;

class MIENACQUISITION_EXPORT vtkLevelOfDetailFilter : public vtkPDEFaceAlgorithm {
 public:
  static vtkLevelOfDetailFilter* New();
  vtkTypeMacro(vtkLevelOfDetailFilter, vtkPDEFaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The table of levels, a row for each.
  vtkTable* GetOutput();

  ///@{
  /** The scan (port 1). */
  void SetScanConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetScanData(vtkDataObject* scan) { this->SetInputDataInternal(1, scan); }
  ///@}

  ///@{
  /** RMS point distances at which the face is stored as a compact face, mm, each 1e-6 .. 100. Default 0.05, 0.1, 0.2,
   * 0.5, 1, 2, 4. */
  void SetTolerances(const std::vector<double>& tolerances);
  std::vector<double> GetTolerances() const { return this->Tolerances; }
  ///@}

  ///@{
  /** z beyond which a point counts, mm. Default 50, the front of a face; any finite number. */
  vtkSetMacro(FrontalThreshold, double);
  vtkGetMacro(FrontalThreshold, double);
  ///@}

  ///@{
  /** Distance between the points at which surfaces are measured, mm. Default 2; 0.1 .. 20. */
  vtkSetMacro(SampleSpacing, double);
  vtkGetMacro(SampleSpacing, double);
  ///@}

 protected:
  vtkLevelOfDetailFilter();
  ~vtkLevelOfDetailFilter() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  vtkLevelOfDetailFilter(const vtkLevelOfDetailFilter&) = delete;
  void operator=(const vtkLevelOfDetailFilter&) = delete;

  std::vector<double> Tolerances;
  double FrontalThreshold = 50.0;
  double SampleSpacing = 2.0;
};

#endif
