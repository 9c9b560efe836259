/**
 * @class vtkPDEInfluenceFilter
 * @brief how far a PDE face moves when one of its curves, or one point of a curve, moves by one unit
 *
 * Input: vtkPolyData, the boundary curves of BoundaryCurveData.h (29 curves of K points, mm).
 * Outputs: port 0 the face as vtkPDEFaceFilter gives it (vtkStructuredGrid, double precision) with the point array
 * `Influence`, three components, the move of the surface per unit of the curve's move in Direction (mm per mm); port 1
 * a vtkTable of how it fades down the face, one line per row of the grid, columns `row`, `curve` (position counted in
 * curves: 1 at C1, 22 at the lips, 28 at C28), `influence_max` (largest length in the row, mm per mm).
 *
 * Equation: S = U B is linear in the curves [Sheng et al. 2011, eq. 1-11], so that the influence is the surface of the
 * moves alone; how the surface forgets them is their section 3.1. Errors: curves that are no face, surface parameters
 * out of range, a curve or point that does not exist, no direction.
 */
#ifndef vtkPDEInfluenceFilter_h
#define vtkPDEInfluenceFilter_h

#include "MienSurfaceModule.h"
#include "vtkPDEFaceFilter.h"

class vtkTable;

namespace mien {
class RowLayout;
struct InfluenceGrid;
}  // namespace mien

class MIENSURFACE_EXPORT vtkPDEInfluenceFilter : public vtkPDEFaceFilter {
 public:
  static vtkPDEInfluenceFilter* New();
  vtkTypeMacro(vtkPDEInfluenceFilter, vtkPDEFaceFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkTable* GetProfile();  ///< output port 1

  ///@{
  /** The curve that moves: "C1" .. "C22", "C22'", "C23" .. "C28". Default "C10". */
  void SetCurve(const std::string& name);
  std::string GetCurve() const { return this->Curve; }
  ///@}

  ///@{
  /** The one point of the curve that moves, 0 .. K - 1, or -1 for the whole curve. Default -1. */
  vtkSetMacro(Point, int);
  vtkGetMacro(Point, int);
  ///@}

  ///@{
  /** Where to it moves; the length does not matter, but must not be 0. Default (0, 0, 1), forwards. */
  vtkSetVector3Macro(Direction, double);
  vtkGetVector3Macro(Direction, double);
  ///@}

  ///@{
  /** How far from the curve the influence of the last update has fallen to half of what it is there, towards C1 (Above)
   * and towards C28 (Below), counted in curves or rows of the grid; NaN where it does not fall so far, and before an
   * update. */
  double GetHalfWidthAbove() const;
  double GetHalfWidthBelow() const;
  double GetHalfWidthAboveInRows() const;
  double GetHalfWidthBelowInRows() const;
  ///@}

 protected:
  vtkPDEInfluenceFilter();
  ~vtkPDEInfluenceFilter() override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  bool IsMadeInParts() const override { return false; }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  vtkPDEInfluenceFilter(const vtkPDEInfluenceFilter&) = delete;
  void operator=(const vtkPDEInfluenceFilter&) = delete;

  std::string DescribeFault(int pointsPerCurve) const;
  int FillOutputs(const mien::InfluenceGrid& influence, const mien::RowLayout& layout, vtkInformation* request,
                  vtkInformationVector* outputs);

  struct Internals;
  std::unique_ptr<Internals> Impl;
  std::string Curve = "C10";
  int Point = -1;
  double Direction[3] = {0.0, 0.0, 1.0};
};

#endif
