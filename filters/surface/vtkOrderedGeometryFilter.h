/**
 * @class vtkOrderedGeometryFilter
 * @brief vtkGeometryFilter whose cells come in the order of the input, on every run
 *
 * Input: vtkDataSet, such as the vtkStructuredGrid of vtkPDEFaceFilter. Output: vtkPolyData as vtkGeometryFilter's,
 * with its polygons and their cell data in the order of the input's cells. vtkGeometryFilter shares large grids among
 * threads and joins their cells as the threads end, so that files differed from run to run, and with them whatever
 * depends on the order of cells, such as a decimated mesh.
 *
 * Errors: those of vtkGeometryFilter.
 */
#ifndef vtkOrderedGeometryFilter_h
#define vtkOrderedGeometryFilter_h

#include "MienSurfaceModule.h"
#include "vtkGeometryFilter.h"

class MIENSURFACE_EXPORT vtkOrderedGeometryFilter : public vtkGeometryFilter {
 public:
  static vtkOrderedGeometryFilter* New();
  vtkTypeMacro(vtkOrderedGeometryFilter, vtkGeometryFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Whether polygons are wound the other way: those of a PDE face, which VTK winds inwards, then face outwards as
   * their normals do, which is what lights a picture. Default off. */
  vtkSetMacro(Reversed, bool);
  vtkGetMacro(Reversed, bool);
  vtkBooleanMacro(Reversed, bool);
  ///@}

 protected:
  vtkOrderedGeometryFilter() { this->PassThroughCellIdsOn(); }
  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

 private:
  vtkOrderedGeometryFilter(const vtkOrderedGeometryFilter&) = delete;
  void operator=(const vtkOrderedGeometryFilter&) = delete;

  bool Reversed = false;
};

#endif
