/**
 * @class vtkFAPAnimationFilter
 * @brief moves the boundary curves of a face by MPEG-4 facial animation parameters (FAPs)
 *
 * Input port 0: vtkPolyData, the neutral boundary curves of BoundaryCurveData.h (29 curves of K >= 32 points,
 * mm) with feature points and pupils. Input port 1, optional: vtkTable of one row, a FAP frame as vtkFAPReader
 * gives it (columns as in FAPTableData.h). FAP 1 (visemes, blended by b / 63) and FAP 2
 * (expressions, intensity / 63) are shapes that are added to the low-level values. Values set with SetFAP(),
 * SetExpression() and SetViseme() are added to the table's. Output: vtkPolyData, the input with moved points (double)
 * and the point array `Displacement` (3 components, mm, against the neutral); all other arrays are passed.
 *
 * Equation: displacement = sum over the FAPs of value x FAPU / 1024 x direction x weight, piecewise linear per
 * FAP [Sheng et al. 2011, section 5]; lips and lids touch but do not cross. No FAPs give the input's points bit for
 * bit.
 *
 * Time: the steps of the FAP table are published on the output, and a time request is passed on to it.
 * Errors: curves that are no face or lack a feature point, a table or animation table that cannot be read. The
 * message says which, and there is no output. FAPs that move nothing are no error: see GetIgnoredFAPs().
 * @sa vtkFAPReader, vtkPDEFaceFilter
 */
#ifndef vtkFAPAnimationFilter_h
#define vtkFAPAnimationFilter_h

#include <memory>
#include <string>
#include <vector>

#include "MienAnimationModule.h"
#include "vtkCommand.h"
#include "vtkPolyDataAlgorithm.h"

namespace mien {
class FAPFrame;
}

class MIENANIMATION_EXPORT vtkFAPAnimationFilter : public vtkPolyDataAlgorithm {
 public:
  static vtkFAPAnimationFilter* New();
  vtkTypeMacro(vtkFAPAnimationFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Invoked when a frame sets FAPs that move nothing and were not reported before; see GetIgnoredFAPs(). */
  enum Events { IgnoredFAPsEvent = vtkCommand::UserEvent + 101 };

  /** The source of FAP frames on port 1; without one only the values set here count. */
  void SetFAPConnection(vtkAlgorithmOutput* frames);

  ///@{
  /** The value of one FAP, in FAP units (FAPU / 1024). Default 0; fap in 3 .. 68, any finite value. */
  void SetFAP(int fap, double value);
  double GetFAP(int fap) const;
  void ClearFAPs();
  ///@}

  ///@{
  /** How much of a named expression is added; several may be mixed. Default 0; 0 .. 1. */
  void SetExpression(const std::string& name, double intensity);
  double GetExpression(const std::string& name) const;
  void ClearExpressions();
  ///@}

  ///@{
  /** How much of a named viseme is added; several may be mixed. Default 0; 0 .. 1. */
  void SetViseme(const std::string& name, double strength);
  double GetViseme(const std::string& name) const;
  void ClearVisemes();
  ///@}

  /** "p b m", "f v", .. "U": those that FAP 1 selects by 1 .. 14, in this order. */
  static const std::vector<std::string>& GetVisemeNames();

  /** "joy", "sadness", "anger", "fear", "disgust", "surprise". */
  static const std::vector<std::string>& GetExpressionNames();

  /** What the expression looks like, in words; empty for a name that is none. */
  static std::string GetExpressionDefinition(const std::string& name);

  /** The FAP value that an expression has at full intensity. */
  static double GetExpressionFAP(const std::string& name, int fap);

  ///@{
  /**
   * A JSON file that says which points each FAP moves. It is read again when it has changed on disk and the filter is
   * updated after Modified(). Default: none, which gives the table compiled in.
   */
  void SetAnimationTableFileName(const std::string& name);
  std::string GetAnimationTableFileName() const;
  ///@}

  ///@{
  /** Results of the last update. */

  /** A FAP unit of the face in mm: "ES", "ENS", "MNS", "MW" or "IRISD"; 0 for other names. */
  double GetFAPUnit(const std::string& symbol) const;

  /** The deepest crossing of lips or lids that was undone, in mm; 0 when none was. */
  double GetContactClamped() const;

  /** The same, the largest of all frames of this face, table and file so far. */
  double GetLargestContactClamped() const;

  /** How many points of the lips and lids that moved. */
  int GetContactPoints() const;

  /** How far curves gave way because their neighbours left them no room, in mm; 0 when all had room. */
  double GetPushed() const;

  /** The same, the largest of all frames of this face, table and file so far. */
  double GetLargestPushed() const;

  /** 1, or the share of the movement that was kept when absurd values would have crossed curves. */
  double GetKeptShare() const;

  /** The same, the smallest of all frames of this face, table and file so far. */
  double GetSmallestKeptShare() const;

  /** The FAPs set in any frame of this face, table and file so far that move nothing: the face or the animation table
   * has no such part. */
  std::vector<int> GetIgnoredFAPs() const;
  ///@}

  /** The animation table's file may have changed: the next update looks. */
  void Modified() override;

 protected:
  vtkFAPAnimationFilter();
  ~vtkFAPAnimationFilter() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  vtkFAPAnimationFilter(const vtkFAPAnimationFilter&) = delete;
  void operator=(const vtkFAPAnimationFilter&) = delete;

  bool CheckFAP(int fap);
  bool IsPrepared(vtkPolyData* curves);
  std::string Prepare(vtkPolyData* curves);
  void ForgetOtherFile(int load);
  void NoteResults(const mien::FAPFrame& frame);

  struct Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
