/**
 * @class vtkWarpMeshReader
 * @brief reads a warp mesh from a CSV file
 *
 * Output: vtkStructuredGrid as described in WarpMeshData.h (pixels). The format is described in WarpMeshText.h.
 * Errors: `FILE:LINE: what is wrong`; the output is then empty. A folded mesh is an error.
 * @sa vtkImageMeshWarpFilter vtkFaceWarpMeshFilter
 */
#ifndef vtkWarpMeshReader_h
#define vtkWarpMeshReader_h

#include "MienTextureModule.h"
#include "vtkStructuredGridAlgorithm.h"

class MIENTEXTURE_EXPORT vtkWarpMeshReader : public vtkStructuredGridAlgorithm {
 public:
  static vtkWarpMeshReader* New();
  vtkTypeMacro(vtkWarpMeshReader, vtkStructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The .csv file. Default: none. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

 protected:
  vtkWarpMeshReader();
  ~vtkWarpMeshReader() override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  vtkWarpMeshReader(const vtkWarpMeshReader&) = delete;
  void operator=(const vtkWarpMeshReader&) = delete;

  char* FileName = nullptr;
};

#endif
