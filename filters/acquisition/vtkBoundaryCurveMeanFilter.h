/**
 * @class vtkBoundaryCurveMeanFilter
 * @brief the symmetric mean face of the boundary curves of several heads
 *
 * Input: any number of connections on port 0, vtkPolyData boundary curves with equal points per curve and the same
 * features (BoundaryCurveData.h, mm).
 * Output: vtkPolyData, the mean curves, feature addresses and pupils; with Symmetric, point j and K - j of each curve
 * mirror each other in x to the last bit.
 * Errors: an input that is no face or differs in points per curve or features; there is no output then.
 */
#ifndef vtkBoundaryCurveMeanFilter_h
#define vtkBoundaryCurveMeanFilter_h

#include "MienAcquisitionModule.h"
#include "vtkPolyDataAlgorithm.h"

class MIENACQUISITION_EXPORT vtkBoundaryCurveMeanFilter : public vtkPolyDataAlgorithm {
 public:
  static vtkBoundaryCurveMeanFilter* New();
  vtkTypeMacro(vtkBoundaryCurveMeanFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Whether the mean is averaged with its mirror image. Default on. */
  vtkSetMacro(Symmetric, bool);
  vtkGetMacro(Symmetric, bool);
  vtkBooleanMacro(Symmetric, bool);
  ///@}

 protected:
  vtkBoundaryCurveMeanFilter();
  ~vtkBoundaryCurveMeanFilter() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  vtkBoundaryCurveMeanFilter(const vtkBoundaryCurveMeanFilter&) = delete;
  void operator=(const vtkBoundaryCurveMeanFilter&) = delete;

  bool Symmetric = true;
};

#endif
