/**
 * @class vtkCurveEditFilter
 * @brief moves points of boundary curves by hand, with a smooth fall-off
 *
 * Input: vtkPolyData, the boundary curves of a face (BoundaryCurveData.h, mm).
 * Output: vtkPolyData, the edited curves with feature points and pupils; without edits the input as it is, bit for bit.
 *
 * All curves are in piece 0. The edits are made in their order; see CurveEdit.h for the fall-off. Feature points keep
 * their addresses, pupils follow the lids. Errors: an input that is no face, a value out of range, an edit that makes
 * curves cross (edit and curves are named); there is no output then.
 * @sa vtkBoundaryCurveReader vtkFAPAnimationFilter
 */
#ifndef vtkCurveEditFilter_h
#define vtkCurveEditFilter_h

#include <memory>  // for std::unique_ptr
#include <string>  // for std::string
#include <vector>  // for std::vector

#include "MienSurfaceModule.h"
#include "vtkPolyDataAlgorithm.h"

namespace mien {
struct CurveEdit;
}

class MIENSURFACE_EXPORT vtkCurveEditFilter : public vtkPolyDataAlgorithm {
 public:
  static vtkCurveEditFilter* New();
  vtkTypeMacro(vtkCurveEditFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The edits, in their order. Default: none. */
  void SetEdits(const std::vector<mien::CurveEdit>& edits);
  const std::vector<mien::CurveEdit>& GetEdits() const;
  ///@}

  /** Appends an edit: curve "C1" .. "C28" or "C22'", v in radians, the move in mm, width in degrees of v, spread in
   * curves. */
  void AddEdit(const std::string& curve, double v, double dx, double dy, double dz, double widthDegrees, int spread,
               bool mirrored);

  void RemoveAllEdits();  ///< the curves pass as they come

 protected:
  vtkCurveEditFilter();
  ~vtkCurveEditFilter() override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  vtkCurveEditFilter(const vtkCurveEditFilter&) = delete;
  void operator=(const vtkCurveEditFilter&) = delete;

  std::unique_ptr<std::vector<mien::CurveEdit>> Edits;
};

#endif
