/**
 * @class vtkFDTFitFilter
 * @brief fits a facial deformation table to a face before and after
 *
 * Inputs: port 0 the neutral face, port 1 the expression: two point sets or meshes with as many points in the same
 * order, each with its own pupils (vtkPupilAlgorithm; pupils set by hand hold for port 0, OtherLeftPupil and
 * OtherRightPupil for port 1). Regions and sides are those of vtkFacialRegionFilter on port 0. Named pupils are left
 * out; of meshes only points wholly on the face count (coverage 1). Output: vtkTable of 16 rows as in FDTData.h (pupil
 * units) with the further columns `points`, `rank` and `rms` (pupil units).
 *
 * Equation: least squares of x' = a1 x^2 + a2 xy + a3 y^2 + a4 x + a5 y + a6, y' alike, per region [Obaid et al. 2009,
 * eq. 1-4; QuadraticFit.h]. Errors: those of vtkPupilAlgorithm; different numbers of points, points that are not
 * finite, regions without points; with Strict regions with fewer than 6 independent points. Without Strict these are a
 * warning that names them, GetWarning() too, and with AllowEmptyRegions so are regions without points, whose map is
 * the identity: the 68 landmarks have none on the forehead (regions 1 and 2).
 * @sa vtkFDTWriter vtkFDTDeformationFilter
 */
#ifndef vtkFDTFitFilter_h
#define vtkFDTFitFilter_h

#include "MienDeformationModule.h"
#include "vtkPupilAlgorithm.h"

class vtkTable;

class MIENDEFORMATION_EXPORT vtkFDTFitFilter : public vtkPupilAlgorithm {
 public:
  static vtkFDTFitFilter* New();
  vtkTypeMacro(vtkFDTFitFilter, vtkPupilAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  vtkTable* GetOutput();  ///< the fitted table

  ///@{
  /** The expression (port 1). */
  void SetExpressionConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetExpressionData(vtkDataObject* data) { this->SetInputData(1, data); }
  ///@}

  ///@{
  /** Pupils of the expression by hand, x y z in its unit. Default: both 0 0 0, which looks for them in the data. */
  vtkSetVector3Macro(OtherLeftPupil, double);
  vtkGetVector3Macro(OtherLeftPupil, double);
  vtkSetVector3Macro(OtherRightPupil, double);
  vtkGetVector3Macro(OtherRightPupil, double);
  ///@}

  ///@{
  /** Whether a region with fewer than 6 independent points is an error. Default off. */
  vtkSetMacro(Strict, bool);
  vtkGetMacro(Strict, bool);
  vtkBooleanMacro(Strict, bool);
  ///@}

  ///@{
  /** Whether regions without points are left as they are, with a warning that names them, where Strict is off; else
   * they are an error. Default off. */
  vtkSetMacro(AllowEmptyRegions, bool);
  vtkGetMacro(AllowEmptyRegions, bool);
  vtkBooleanMacro(AllowEmptyRegions, bool);
  ///@}

  /// After an update: root mean square of what is left over all points, pupil units.
  vtkGetMacro(RMS, double);

  /// After an update: one sentence that names the empty and the sparse regions, or nothing.
  vtkGetMacro(Warning, std::string);

 protected:
  vtkFDTFitFilter();
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  vtkFDTFitFilter(const vtkFDTFitFilter&) = delete;
  void operator=(const vtkFDTFitFilter&) = delete;

  double OtherLeftPupil[3] = {0.0, 0.0, 0.0};
  double OtherRightPupil[3] = {0.0, 0.0, 0.0};
  bool Strict = false;
  bool AllowEmptyRegions = false;
  double RMS = 0.0;
  std::string Warning;
};

#endif
