/**
 * @class vtkFDTReader
 * @brief reads a facial deformation table from a CSV file, or one that is compiled in
 *
 * Output: vtkTable of 16 rows, columns as described in FDTData.h (pupil units). The format is described in TableText.h.
 * Errors: `FILE:LINE: what is wrong`; the output is then empty.
 * @sa vtkFDTWriter vtkFDTDeformationFilter
 */
#ifndef vtkFDTReader_h
#define vtkFDTReader_h

#include "MienDeformationModule.h"
#include "vtkTableAlgorithm.h"

class MIENDEFORMATION_EXPORT vtkFDTReader : public vtkTableAlgorithm {
 public:
  static vtkFDTReader* New();
  vtkTypeMacro(vtkFDTReader, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The .csv file, or the name of a table that is compiled in (NamedTables.h: joy, smile ..). Default: none. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

 protected:
  vtkFDTReader();
  ~vtkFDTReader() override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  vtkFDTReader(const vtkFDTReader&) = delete;
  void operator=(const vtkFDTReader&) = delete;

  char* FileName = nullptr;
};

#endif
