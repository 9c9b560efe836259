/**
 * @class vtkPDEPatchFilter
 * @brief one PDE patch between any closed curves, as a structured grid
 *
 * Input: vtkPolyData, 2m closed polylines (2m even, 2 .. 16) of K points each, K even and at least 8, in the unit of
 * your choice. Each gives one condition: the surface, or its u-derivative of some order, equals the curve at some u.
 * Conditions come from AddCondition(), else from the cell arrays `U` (0 .. 1) and `Derivative` (whole numbers 0 .. 2m -
 * 1), else the curves are passed in their order at equal steps of u. Output: vtkStructuredGrid of (NumberOfColumns + 1)
 * x NumberOfRows points, v fastest, the last column repeating the first. Point arrays `Normals`, `TextureCoordinates`
 * (v / 2 pi, 1 - u), optionally `Su`, `Sv`; cell array `PatchId` = 0.
 *
 * Equation: (d2/du2 + a^2 d2/dv2)^m S = 0 [Sheng et al. 2011, eq. 1-11, for any order 2m].
 * Errors: curves that are not closed, differ in length or go past 1e15; conditions that do not determine a surface, and
 * a and N with which it exceeds its curves more than 1e37 times, as through inner curves where a (N + 1) passes 250.
 */
#ifndef vtkPDEPatchFilter_h
#define vtkPDEPatchFilter_h

#include <memory>

#include "MienSurfaceModule.h"
#include "vtkStructuredGridAlgorithm.h"

class MIENSURFACE_EXPORT vtkPDEPatchFilter : public vtkStructuredGridAlgorithm {
 public:
  static vtkPDEPatchFilter* New();
  vtkTypeMacro(vtkPDEPatchFilter, vtkStructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The condition that the next curve gives: where (u, 0 .. 1) and which derivative (0 .. 2m - 1). Default: none. */
  void AddCondition(double u, int derivative);
  void ClearConditions();
  int GetNumberOfConditions() const;
  ///@}

  ///@{
  /** The smoothing parameter a. No unit; default 1, 0 < a <= 1000. */
  vtkSetMacro(Smoothing, double);
  vtkGetMacro(Smoothing, double);
  ///@}

  ///@{
  /** N: how many Fourier modes are solved exactly. Default 5; 0 .. K / 2. */
  vtkSetMacro(NumberOfModes, int);
  vtkGetMacro(NumberOfModes, int);
  ///@}

  ///@{
  /** Whether all harmonics above N follow as one remainder. Default on. */
  vtkSetMacro(Remainder, bool);
  vtkGetMacro(Remainder, bool);
  vtkBooleanMacro(Remainder, bool);
  ///@}

  ///@{
  /** Rows (u) and columns (v, without the closing one). Default 40 x 40; at least 2 x 3, at most
   *  134217728 points. */
  void SetResolution(int rows, int columns);
  vtkGetMacro(NumberOfRows, int);
  vtkGetMacro(NumberOfColumns, int);
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
  vtkPDEPatchFilter();
  ~vtkPDEPatchFilter() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  vtkPDEPatchFilter(const vtkPDEPatchFilter&) = delete;
  void operator=(const vtkPDEPatchFilter&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Impl;
  double Smoothing = 1.0;
  int NumberOfModes = 5;
  bool Remainder = true;
  int NumberOfRows = 40;
  int NumberOfColumns = 40;
  bool GenerateDerivatives = false;
  int OutputPointsPrecision = SINGLE_PRECISION;
};

#endif
