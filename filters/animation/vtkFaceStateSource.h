/**
 * @class vtkFaceStateSource
 * @brief the face that a FaceState describes, through the same pipeline as every program of Mien
 *
 * Outputs: port 0 vtkStructuredGrid, the surface as vtkPDEFaceFilter and, with a table, vtkFDTDeformationFilter give it
 * (the mouth's slit is blanked); port 1 vtkPolyData, its visible cells wound outwards, with the same arrays; port 2
 * vtkPolyData, the boundary curves as they are shown. Lengths in mm.
 * A state with an animation file publishes TIME_STEPS (s), and a time that is asked for takes the place of the state's
 * own choice of a frame. The first piece is the whole face, others are empty: pipelines that stream are built of the
 * filters themselves.
 *
 * Errors: text that is no FaceState, files that cannot be read, values out of range; each one sentence.
 * @sa vtkBoundaryCurveReader vtkFAPAnimationFilter vtkPDEFaceFilter vtkFDTDeformationFilter
 */
#ifndef vtkFaceStateSource_h
#define vtkFaceStateSource_h

#include <memory>
#include <string>

#include "MienAnimationModule.h"
#include "vtkStructuredGridAlgorithm.h"

class vtkPolyData;

class MIENANIMATION_EXPORT vtkFaceStateSource : public vtkStructuredGridAlgorithm {
 public:
  static vtkFaceStateSource* New();
  vtkTypeMacro(vtkFaceStateSource, vtkStructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The face as JSON (FaceStateText.h); what is left out has its default. Default: the generic face at rest. Text that
   * cannot be read is an error and changes nothing. The getter gives every member. */
  void SetState(const std::string& text);
  std::string GetState() const;
  ///@}

  /** Later after a failure, so that the next update looks whether what was wrong has been mended. */
  vtkMTimeType GetMTime() override;

  vtkPolyData* GetSurface();  ///< port 1
  vtkPolyData* GetCurves();   ///< port 2

 protected:
  vtkFaceStateSource();
  ~vtkFaceStateSource() override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  vtkFaceStateSource(const vtkFaceStateSource&) = delete;
  void operator=(const vtkFaceStateSource&) = delete;

  int Refuse(const std::string& fault);
  void PublishTimes(vtkInformationVector* outputs);

  struct Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
