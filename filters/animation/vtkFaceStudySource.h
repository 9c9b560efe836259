/**
 * @class vtkFaceStudySource
 * @brief every case of a study, measured: one row each
 *
 * Output: vtkTable; columns `case` (vtkIdType, from 0), `id`, `face`, `scheme` (string), `a` (double), `harmonics`
 * (int), `expression` (string), `frame` (double), the study's measures (double, their names end in their units),
 * `reason` (string). What is not there is NaN. doc/studies.md says what a study is. Pieces share the cases out, so that
 * every process of a parallel ParaView computes its own. With a table's name rows are kept in parts beside it as they
 * come: a later run, with as many pieces or others, computes none of them again, and WriteTable() makes the table of
 * them. It is the table of `mien ensemble`, to the byte.
 *
 * Errors: a study, face, animation or part that cannot be read or written, no study's name; each one sentence.
 */
#ifndef vtkFaceStudySource_h
#define vtkFaceStudySource_h

#include "MienAnimationModule.h"
#include "vtkTableAlgorithm.h"

class MIENANIMATION_EXPORT vtkFaceStudySource : public vtkTableAlgorithm {
 public:
  static vtkFaceStudySource* New();
  vtkTypeMacro(vtkFaceStudySource, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The study, STUDY.json. Default: none. */
  vtkSetFilePathMacro(StudyFileName);
  vtkGetFilePathMacro(StudyFileName);
  ///@}

  ///@{
  /** The table, TABLE.csv, beside which rows are kept. Default: none, rows are only in the output. */
  vtkSetFilePathMacro(TableFileName);
  vtkGetFilePathMacro(TableFileName);
  ///@}

  ///@{
  /** How many cases are computed at once, 0 .. 1024. Default: 0, one for each processor, or one for each piece when
   * there are several. */
  vtkSetClampMacro(NumberOfThreads, int, 0, 1024);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  /** How many cases the last update computed, rather than finding them done. */
  vtkGetMacro(NumberOfComputedCases, vtkIdType);

  /** After all pieces are done: writes the table named TableFileName of all parts, and takes the parts away. Of several
   * processes (vtkMultiProcessController) the first does it. An error when a case is still missing.
   * @return whether the table is written, or another process does it */
  bool WriteTable();

 protected:
  vtkFaceStudySource();
  ~vtkFaceStudySource() override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  vtkFaceStudySource(const vtkFaceStudySource&) = delete;
  void operator=(const vtkFaceStudySource&) = delete;

  int Compute(int piece, int pieces, vtkTable* table);

  char* StudyFileName = nullptr;
  char* TableFileName = nullptr;
  int NumberOfThreads = 0;
  vtkIdType NumberOfComputedCases = 0;
};

#endif
