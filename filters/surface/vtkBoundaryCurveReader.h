/**
 * @class vtkBoundaryCurveReader
 * @brief reads and checks the boundary curves of a face; without a file, gives the generic face
 *
 * Output: vtkPolyData with 29 closed polylines as described in BoundaryCurveData.h (lengths in mm). From a compact face
 * file also the field arrays `StoredError` (1 x 2: RMS and largest distance to the curves that were stored, mm) and,
 * where it has one, `FaceName`. Errors: a file that cannot be read, is damaged or cut off; curves missing, with too few
 * points, not finite or crossed. The message names the file and the curve, and there is no output.
 * @sa vtkCompactFaceWriter
 */
#ifndef vtkBoundaryCurveReader_h
#define vtkBoundaryCurveReader_h

#include "MienSurfaceModule.h"
#include "vtkPolyDataAlgorithm.h"

class MIENSURFACE_EXPORT vtkBoundaryCurveReader : public vtkPolyDataAlgorithm {
 public:
  static vtkBoundaryCurveReader* New();
  vtkTypeMacro(vtkBoundaryCurveReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The .vtp or .mienz file. Default: none, which gives the generic face that is compiled in. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /** Whether a file holds boundary curves without a fault: 1 or 0, in silence. Files beyond 64 MB are not looked into.
   */
  static int CanReadFile(const char* fileName);

 protected:
  vtkBoundaryCurveReader();
  ~vtkBoundaryCurveReader() override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  vtkBoundaryCurveReader(const vtkBoundaryCurveReader&) = delete;
  void operator=(const vtkBoundaryCurveReader&) = delete;

  char* FileName = nullptr;
};

#endif
