/**
 * @class vtkMotionVectorFilter
 * @brief motion vectors from one surface to another of the same topology
 *
 * Inputs: port 0 the moved surface, port 1 the neutral one (any vtkPointSet each, mm: polygons, structured grids ...),
 * with the same points and cells. Output: vtkPolyData with one vertex per point at the neutral point (the origin of the
 * vector), the neutral point arrays, and the point arrays (double) `MotionVector` (3 components, mm), `Magnitude` (mm,
 * length of the vector in space), `ProjectedOrigin` and `ProjectedVector` (2 components, mm: right and up in the plane
 * of the picture).
 *
 * Equation: vector = moved - neutral [Sheng et al. 2011, section 5]; the projection is orthogonal along ViewDirection.
 * With RemoveHeadRotation each surface is first turned back by its own field array `HeadRotation` (1 x 12, as
 * vtkFAPAnimationFilter writes it); with RemoveRigidMotion the rigid motion of the part that keeps its shape is then
 * undone: least squares [Kabsch 1976] with weights that leave out what moves by itself (mien::fitStillPart). With
 * neither a vector is the difference of its points to the bit. Time: the steps of both inputs are published, and a time
 * request is passed on to both. Pieces: those of the inputs, points that two pieces of a grid share having a vertex in
 * one of them; while RemoveRigidMotion is on, all is in piece 0, because the fit needs all points. Limitations: the fit
 * needs a quarter of the points, at least, that move with the head alone. Errors: an input without points, points that
 * are not finite, different topology, a `HeadRotation` that is none, a view up along the view direction.
 * @sa vtkFAPAnimationFilter
 */
#ifndef vtkMotionVectorFilter_h
#define vtkMotionVectorFilter_h

#include <string>
#include <vector>

#include "MienAnimationModule.h"
#include "vtkPolyDataAlgorithm.h"

class vtkPointSet;

class MIENANIMATION_EXPORT vtkMotionVectorFilter : public vtkPolyDataAlgorithm {
 public:
  static vtkMotionVectorFilter* New();
  vtkTypeMacro(vtkMotionVectorFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The surface that the vectors start from (port 1). */
  void SetNeutralConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetNeutralData(vtkDataObject* neutral) { this->SetInputData(1, neutral); }
  ///@}

  ///@{
  /** Whether the rigid motion of the part that keeps its shape is removed. Default off. */
  vtkSetMacro(RemoveRigidMotion, bool);
  vtkGetMacro(RemoveRigidMotion, bool);
  vtkBooleanMacro(RemoveRigidMotion, bool);
  ///@}

  ///@{
  /** Whether the head's rotation that the inputs know is undone; nothing for inputs without the array. Default off. */
  vtkSetMacro(RemoveHeadRotation, bool);
  vtkGetMacro(RemoveHeadRotation, bool);
  vtkBooleanMacro(RemoveHeadRotation, bool);
  ///@}

  ///@{
  /** From the surface to the viewer. Default (0, 0, 1), the front; any vector but 0. */
  vtkSetVector3Macro(ViewDirection, double);
  vtkGetVector3Macro(ViewDirection, double);
  ///@}

  ///@{
  /** What is up in the picture. Default (0, 1, 0); any vector not along ViewDirection. */
  vtkSetVector3Macro(ViewUp, double);
  vtkGetVector3Macro(ViewUp, double);
  ///@}

  ///@{
  /** Results of the last update: the longest vector (mm), and the rigid motion removed (degrees; 9 numbers row by row;
   * mm). */
  vtkGetMacro(LargestMagnitude, double);
  vtkGetMacro(RigidAngle, double);
  std::vector<double> GetRigidRotation() const { return this->RigidRotation; }
  std::vector<double> GetRigidTranslation() const { return this->RigidTranslation; }
  ///@}

 protected:
  vtkMotionVectorFilter();
  ~vtkMotionVectorFilter() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  vtkMotionVectorFilter(const vtkMotionVectorFilter&) = delete;
  void operator=(const vtkMotionVectorFilter&) = delete;

  struct Field;
  std::string Compute(vtkPointSet* moved, vtkPointSet* neutral, Field& field);
  bool Write(vtkPointSet* neutral, const Field& field, vtkPolyData* output);

  bool RemoveRigidMotion = false;
  bool RemoveHeadRotation = false;
  double ViewDirection[3] = {0.0, 0.0, 1.0};
  double ViewUp[3] = {0.0, 1.0, 0.0};
  double LargestMagnitude = 0.0;
  double RigidAngle = 0.0;
  std::vector<double> RigidRotation;
  std::vector<double> RigidTranslation;
};

#endif
