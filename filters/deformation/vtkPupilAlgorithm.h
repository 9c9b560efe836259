/**
 * @class vtkPupilAlgorithm
 * @brief what filters that need the pupils of a face have in common
 *
 * Input: points or a mesh (any vtkPointSet; y up, z forward). The pupils are those set by hand, else the points named
 * LeftPupilName and RightPupilName in the point array `marker` (strings), else the field array `Pupils` (2 x 3, the
 * subject's left first), else those of the 68 landmarks on a mesh: the middle of the eyeball's vertices, or of the
 * eye's six landmarks without eyeballs (EyePupils.h). The field array `HeadRotation` (BoundaryCurveData.h) is taken
 * into account. The whole input is asked for whatever part of the output is wanted; the wanted part of a grid is cut
 * out, and other data are given as piece 0. Errors: no pupils, pupils that coincide or are not finite, a landmark file
 * or region map that is none.
 * @sa vtkPupilNormalizeFilter vtkFacialRegionFilter vtkFDTDeformationFilter
 */
#ifndef vtkPupilAlgorithm_h
#define vtkPupilAlgorithm_h

#include <functional>
#include <string>

#include "MienDeformationModule.h"
#include "vtkPointSetAlgorithm.h"

namespace mien {
struct FaceFrameOptions;
}

class MIENDEFORMATION_EXPORT vtkPupilAlgorithm : public vtkPointSetAlgorithm {
 public:
  vtkTypeMacro(vtkPupilAlgorithm, vtkPointSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The pupils by hand in the input's unit, x y z, left being the subject's. Default: both 0 0 0, which looks for them
   * in the data. */
  vtkSetVector3Macro(LeftPupil, double);
  vtkGetVector3Macro(LeftPupil, double);
  vtkSetVector3Macro(RightPupil, double);
  vtkGetVector3Macro(RightPupil, double);
  ///@}

  ///@{
  /** Names of the pupils among the points of markers. Default pupil_left, pupil_right. */
  vtkSetMacro(LeftPupilName, std::string);
  vtkGetMacro(LeftPupilName, std::string);
  vtkSetMacro(RightPupilName, std::string);
  vtkGetMacro(RightPupilName, std::string);
  ///@}

  ///@{
  /** CSV with the 68 landmarks of a mesh by vertex or by place (LandmarkTable.h): for its pupils, and to tell lips and
   * lids apart. Default: none. */
  vtkSetMacro(LandmarkFileName, std::string);
  vtkGetMacro(LandmarkFileName, std::string);
  ///@}

  ///@{
  /** Region map of one's own (JSON, FacialRegions.h). Default: none, the 16 regions of data/deformation/regions.json.
   */
  vtkSetMacro(RegionFileName, std::string);
  vtkGetMacro(RegionFileName, std::string);
  ///@}

 protected:
  vtkPupilAlgorithm() = default;
  /// Any part of a grid can be asked for.
  int ExecuteInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int ComputeInputUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// The properties above as the mathematics takes them.
  mien::FaceFrameOptions GetFrameOptions() const;

  /// Reports the part `from` .. `to` of an update's progress, and stops when the update is aborted.
  std::function<bool(double)> ReportProgress(double from, double to);

  /// Cuts the wanted part out of an output that was made whole.
  static void KeepWantedPart(vtkInformation* info);

 private:
  vtkPupilAlgorithm(const vtkPupilAlgorithm&) = delete;
  void operator=(const vtkPupilAlgorithm&) = delete;

  double LeftPupil[3] = {0.0, 0.0, 0.0};
  double RightPupil[3] = {0.0, 0.0, 0.0};
  std::string LeftPupilName = "pupil_left", RightPupilName = "pupil_right";
  std::string LandmarkFileName, RegionFileName;
};

#endif
