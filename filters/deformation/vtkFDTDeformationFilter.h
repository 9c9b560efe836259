/**
 * @class vtkFDTDeformationFilter
 * @brief moves the points of a face by a facial deformation table
 *
 * Inputs: port 0 points or a mesh of any size with pupils (vtkPupilAlgorithm; mm, y up, z forward); regions, sides of
 * lips and lids and coverage are those of vtkFacialRegionFilter. Port 1 the table, 16 rows, columns `region`, `a1` ..
 * `b6` (FDTData.h); port 2, optional, a second table to interpolate to. Output: a copy of the input with moved points
 * (of the input's precision) and the point array `Displacement` (3 components, the input's unit). `Normals` of the
 * input turn as the polygons around each point do, and stay where there are no polygons; derivatives and curvatures of
 * a surface (`Su`, `Sv`, `MeanCurvature` ..) are left out, as the moved points make them untrue. Eyeballs that
 * landmarks tell (EyePupils.h) stay where they are.
 *
 * Equation: x' = a1 x^2 + a2 xy + a3 y^2 + a4 x + a5 y + a6 and y' alike per region, in pupil units [Obaid et al. 2009,
 * eq. 1]; blending and limits are described in TableDeformation.h. z is carried along unchanged in the head's frame.
 * The weights are kept while the input and the settings that decide them stay: tables, strength and interpolation may
 * change at the cost of moving the points and, where there are `Normals`, of turning these. Tables are for faces that
 * look along +z: by its landmarks a face may look 10 degrees aside (doc/decisions.md), gets a warning beyond and is
 * refused beyond 45. Errors: those of vtkPupilAlgorithm, a table that is none, points or arrays that are not finite.
 * @sa vtkFDTReader vtkFDTFitFilter vtkFacialRegionFilter
 */
#ifndef vtkFDTDeformationFilter_h
#define vtkFDTDeformationFilter_h

#include <memory>

#include "MienDeformationModule.h"
#include "vtkPupilAlgorithm.h"

class MIENDEFORMATION_EXPORT vtkFDTDeformationFilter : public vtkPupilAlgorithm {
 public:
  static vtkFDTDeformationFilter* New();
  vtkTypeMacro(vtkFDTDeformationFilter, vtkPupilAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The table (port 1), and the one that Interpolation goes to (port 2, optional). */
  void SetTableConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetTableData(vtkDataObject* table) { this->SetInputData(1, table); }
  void SetOtherTableConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(2, output); }
  void SetOtherTableData(vtkDataObject* table) { this->SetInputData(2, table); }
  ///@}

  ///@{
  /** Factor of all displacements. Default 1; any finite number, sensible from 0 to 1.5. */
  vtkSetMacro(Strength, double);
  vtkGetMacro(Strength, double);
  ///@}

  ///@{
  /** Place between the table (0) and the other table (1). Default 0; range 0 to 1. Ignored without another table. */
  vtkSetClampMacro(Interpolation, double, 0.0, 1.0);
  vtkGetMacro(Interpolation, double);
  ///@}

  ///@{
  /** Whether neighbouring regions are blended (default), or every point follows the nearest centre alone, as in the
   * paper. */
  vtkSetMacro(Smooth, bool);
  vtkGetMacro(Smooth, bool);
  vtkBooleanMacro(Smooth, bool);
  ///@}

 protected:
  vtkFDTDeformationFilter();
  ~vtkFDTDeformationFilter() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  vtkFDTDeformationFilter(const vtkFDTDeformationFilter&) = delete;
  void operator=(const vtkFDTDeformationFilter&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Impl;
  double Strength = 1.0;
  double Interpolation = 0.0;
  bool Smooth = true;
};

#endif
