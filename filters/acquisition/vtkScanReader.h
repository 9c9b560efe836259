/**
 * @class vtkScanReader
 * @brief reads a scan of a head (.ply, .obj, .stl, .off)
 *
 * Output: vtkPolyData of triangles (larger polygons are split), double precision points, lengths in the
 * unit of the file, which it does not say. Vertices keep the file's numbering, which landmark files refer to.
 * Errors: a missing or damaged file, another format, no triangles; the message names the file and,
 * in text, the line, and there is no output.
 */
#ifndef vtkScanReader_h
#define vtkScanReader_h

#include "MienAcquisitionModule.h"
#include "vtkPolyDataAlgorithm.h"

class MIENACQUISITION_EXPORT vtkScanReader : public vtkPolyDataAlgorithm {
 public:
  static vtkScanReader* New();
  vtkTypeMacro(vtkScanReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The scan. Default: none, which is an error. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

 protected:
  vtkScanReader();
  ~vtkScanReader() override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  vtkScanReader(const vtkScanReader&) = delete;
  void operator=(const vtkScanReader&) = delete;

  char* FileName = nullptr;
};

#endif
