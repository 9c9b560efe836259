/**
 * @class vtkBoundaryCurveAcquisitionFilter
 * @brief measures the 29 boundary curves of a face from a scan with 68 landmarks
 *
 * Input: vtkPolyData, the surface of a whole head in mm, +x the subject's left, +y up, +z forward.
 * Output: vtkPolyData, boundary curves with feature points and pupils as in BoundaryCurveData.h (mm, radians).
 *
 * Each curve follows landmarks at the front and runs evenly spaced at the back; its points lie where horizontal
 * rays from an axis in the head leave the skin, at azimuths t - 0.6 sin t with t = v - pi
 * [Sheng et al. 2011, 4.1]. Ears are taken off. Lips are measured as closed.
 * Errors: no landmark file or a wrong one (file and line), a vertex the mesh does not have, a mesh with holes
 * where a curve runs, curves that would cross; there is no output then.
 * @sa vtkScanReader vtkBoundaryCurveMeanFilter
 */
#ifndef vtkBoundaryCurveAcquisitionFilter_h
#define vtkBoundaryCurveAcquisitionFilter_h

#include "MienAcquisitionModule.h"
#include "vtkPolyDataAlgorithm.h"

class MIENACQUISITION_EXPORT vtkBoundaryCurveAcquisitionFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkBoundaryCurveAcquisitionFilter* New();
  vtkTypeMacro(vtkBoundaryCurveAcquisitionFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** CSV with the columns landmark, vertex or landmark, x, y, z (mm); see LandmarkTable.h. Default: none, which is an
   *  error. */
  vtkSetFilePathMacro(LandmarkFileName);
  vtkGetFilePathMacro(LandmarkFileName);
  ///@}

  ///@{
  /** K, samples per curve. Default 40; even, 8 .. 4096. */
  vtkSetMacro(PointsPerCurve, int);
  vtkGetMacro(PointsPerCurve, int);
  ///@}

protected:
  vtkBoundaryCurveAcquisitionFilter();
  ~vtkBoundaryCurveAcquisitionFilter() override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkBoundaryCurveAcquisitionFilter(const vtkBoundaryCurveAcquisitionFilter&) = delete;
  void operator=(const vtkBoundaryCurveAcquisitionFilter&) = delete;

  char* LandmarkFileName = nullptr;
  int PointsPerCurve = 40;
};

#endif
