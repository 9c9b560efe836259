/**
 * @class vtkFDTWriter
 * @brief writes a facial deformation table to a CSV file or a packed one
 *
 * Input: vtkTable of 16 rows, columns as described in FDTData.h. Text is read back without a difference, packed
 * tables within packingError() of PackedTable.h and without deviations. A file is written under a temporary name
 * (WholeFile.h) and renamed. Errors: a table that is none or too large to be packed, no name, a file that cannot be
 * written.
 * @sa vtkFDTReader
 */
#ifndef vtkFDTWriter_h
#define vtkFDTWriter_h

#include <string>

#include "MienDeformationModule.h"
#include "vtkWriter.h"

class MIENDEFORMATION_EXPORT vtkFDTWriter : public vtkWriter {
 public:
  static vtkFDTWriter* New();
  vtkTypeMacro(vtkFDTWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The file. Default: none. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /** 0: text (default); 8 or 16: packed with so many bits a coefficient, without deviations and comment
   * (PackedTable.h). */
  vtkSetMacro(Bits, int);
  vtkGetMacro(Bits, int);
  ///@}

  ///@{
  /** Lines for the head of the file: what the table is of, and its source. Default: none. */
  vtkSetMacro(Comment, std::string);
  vtkGetMacro(Comment, std::string);
  ///@}

 protected:
  vtkFDTWriter() = default;
  ~vtkFDTWriter() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

 private:
  vtkFDTWriter(const vtkFDTWriter&) = delete;
  void operator=(const vtkFDTWriter&) = delete;

  char* FileName = nullptr;
  int Bits = 0;
  std::string Comment;
};

#endif
