/**
 * @class vtkSurfaceDistanceFilter
 * @brief two-sided distance between a surface and a reference mesh
 *
 * Inputs: port 0 the surface, port 1 the reference, each vtkPolyData or vtkStructuredGrid (of which the visible cells
 * are taken, as vtkGeometryFilter does), lengths in mm. Outputs: port 0 the surface and port 1 the reference as
 * vtkPolyData with the point array `Distance` (mm, double) to the other, and with GenerateVectors `DistanceVector`
 * (3 components, mm, double) to its nearest point, and with CoveredOnly `Covered` (unsigned char, 1 where the point
 * counts as covered); port 2 a vtkTable with one row each way,
 * columns `direction` ("to reference", "from reference"), `rms_mm`, `mean_mm`, `median_mm`, `p95_mm`, `max_mm`,
 * `area_mm2` and `points`. RMS, mean, median and 95th percentile are weighted with the area that belongs to each
 * point, a third of every triangle around it.
 *
 * Equation: d(p) = min over q of |p - q|; signs from angle-weighted pseudonormals [Baerentzen and Aanaes 2005].
 * Limitations: distances are taken at points, not integrated over triangles, so a coarse surface is measured coarsely.
 * Parts of the reference that the surface does not cover (a head's neck) count in the way back unless CoveredOnly is
 * on. Errors: an input without polygons or with points that are not finite, a threshold beyond which nothing lies,
 * surfaces of which nothing is covered.
 */
#ifndef vtkSurfaceDistanceFilter_h
#define vtkSurfaceDistanceFilter_h

#include <memory>
#include <string>

#include "MienSurfaceModule.h"
#include "vtkPolyDataAlgorithm.h"

namespace mien {
struct DistanceSummary;
}

class MIENSURFACE_EXPORT vtkSurfaceDistanceFilter : public vtkPolyDataAlgorithm {
 public:
  static vtkSurfaceDistanceFilter* New();
  vtkTypeMacro(vtkSurfaceDistanceFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The mesh that the surface is compared with (port 1). */
  void SetReferenceConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetReferenceData(vtkDataObject* reference) { this->SetInputData(1, reference); }
  ///@}

  ///@{
  /** Whether RMS, mean and maximum take points in front of FrontalThreshold only. Default off. The array has all
   * points. */
  vtkSetMacro(FrontalOnly, bool);
  vtkGetMacro(FrontalOnly, bool);
  vtkBooleanMacro(FrontalOnly, bool);
  ///@}

  ///@{
  /** z beyond which a point is frontal, mm. Default 50, the front of a face; any finite number. */
  vtkSetMacro(FrontalThreshold, double);
  vtkGetMacro(FrontalThreshold, double);
  ///@}

  ///@{
  /** Whether `Distance` is negative behind the other surface (in front is where its point normals point, or its
   *  triangles without them). Default off. */
  vtkSetMacro(Signed, bool);
  vtkGetMacro(Signed, bool);
  vtkBooleanMacro(Signed, bool);
  ///@}

  ///@{
  /** Whether `DistanceVector` is added. Default off. */
  vtkSetMacro(GenerateVectors, bool);
  vtkGetMacro(GenerateVectors, bool);
  vtkBooleanMacro(GenerateVectors, bool);
  ///@}

  ///@{
  /** Whether only the reference's largest connected part counts: the skin of a head without its eyeballs. Default off.
   */
  vtkSetMacro(LargestComponentOnly, bool);
  vtkGetMacro(LargestComponentOnly, bool);
  vtkBooleanMacro(LargestComponentOnly, bool);
  ///@}

  ///@{
  /** Whether RMS, mean, percentiles and maximum take only points that the other surface covers: those whose nearest
   * point does not lie on its rim, where it ends outside or at a hole. Both ways. Default off. The array has all
   * points. */
  vtkSetMacro(CoveredOnly, bool);
  vtkGetMacro(CoveredOnly, bool);
  vtkBooleanMacro(CoveredOnly, bool);
  ///@}

  ///@{
  /** Of the last update, mm; direction 0 is from the surface to the reference, 1 the other way. */
  double GetRMSDistance(int direction = 0) const;
  double GetMeanDistance(int direction = 0) const;
  double GetMaximumDistance(int direction = 0) const;
  double GetMedianDistance(int direction = 0) const;
  double GetPercentile95Distance(int direction = 0) const;
  ///@}

  /** All numbers of the last update in one; see SurfaceDistance.h. Of C++ only. */
  const mien::DistanceSummary& GetSummary(int direction = 0) const;

 protected:
  vtkSurfaceDistanceFilter();
  ~vtkSurfaceDistanceFilter() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  vtkSurfaceDistanceFilter(const vtkSurfaceDistanceFilter&) = delete;
  void operator=(const vtkSurfaceDistanceFilter&) = delete;

  int Refuse(const std::string& fault);
  int RefuseEmptiness(int port);

  struct Internals;
  std::unique_ptr<Internals> Impl;
  bool FrontalOnly = false;
  double FrontalThreshold = 50.0;
  bool Signed = false;
  bool GenerateVectors = false;
  bool LargestComponentOnly = false;
  bool CoveredOnly = false;
};

#endif
