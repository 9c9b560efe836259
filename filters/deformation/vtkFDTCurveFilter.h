/**
 * @class vtkFDTCurveFilter
 * @brief moves the boundary curves of a face by a facial deformation table, as its surface moves
 *
 * Inputs: port 0 the boundary curves of a face as vtkPolyData (BoundaryCurveData.h), port 1 a table (FDTData.h).
 * Output: the curves with moved points of the input's precision; the table's displacements are added to the point array
 * `Displacement` (3 components, mm) of the input, or make one.
 *
 * Lips and lids are told apart by their curves: above C22 is the upper side, from C22' on the lower one; C9 is the
 * upper lid and C10 the lower. Equation and limits as in vtkFDTDeformationFilter; the curves' normals are those of
 * rings around the head. Curves that the table would make cross are put in order (MovedCurveOrder.h). Errors: curves
 * without pupils, a table that is none.
 * @sa vtkFDTDeformationFilter vtkFAPAnimationFilter
 */
#ifndef vtkFDTCurveFilter_h
#define vtkFDTCurveFilter_h

#include "MienDeformationModule.h"
#include "vtkPolyDataAlgorithm.h"

class MIENDEFORMATION_EXPORT vtkFDTCurveFilter : public vtkPolyDataAlgorithm {
 public:
  static vtkFDTCurveFilter* New();
  vtkTypeMacro(vtkFDTCurveFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The table (port 1). */
  void SetTableConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }

  ///@{
  /** Factor of all displacements. Default 1; any finite number, sensible from 0 to 1.5. */
  vtkSetMacro(Strength, double);
  vtkGetMacro(Strength, double);
  ///@}

  ///@{
  /** Whether neighbouring regions are blended (default), or every point follows the nearest centre alone. */
  vtkSetMacro(Smooth, bool);
  vtkGetMacro(Smooth, bool);
  vtkBooleanMacro(Smooth, bool);
  ///@}

  ///@{
  /** The furthest that a point gave way along y so that no curves cross at their points, mm; the share of the movement
   * that was kept, 1 unless giving way was not enough; and the places between points (of eight) where a curve still
   * lies more than 0.1 mm below the next. Of the last update. */
  vtkGetMacro(Pushed, double);
  vtkGetMacro(KeptShare, double);
  vtkGetMacro(Crossings, int);
  ///@}

 protected:
  vtkFDTCurveFilter();
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  vtkFDTCurveFilter(const vtkFDTCurveFilter&) = delete;
  void operator=(const vtkFDTCurveFilter&) = delete;

  double Strength = 1.0;
  bool Smooth = true;
  double Pushed = 0.0, KeptShare = 1.0;
  int Crossings = 0;
};

#endif
