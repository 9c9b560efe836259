/**
 * @class vtkBoundaryCurveAcquisitionFilter
 * @brief measures the 29 boundary curves of a face from a scan, with 68 landmarks or without
 *
 * Input: vtkPolyData, the surface of a whole head in any unit and pose; holes, loose parts and eyeballs may be there.
 * Output 0: vtkPolyData, boundary curves with feature points and pupils as in BoundaryCurveData.h (mm, radians), and
 * the field array `ScanToFace` (1 x 16: the matrix, row by row, from the scan's coordinates to those of the curves).
 * Output 1: vtkPolyData, the scan that was measured: cleaned, in mm, in the frame of the curves.
 *
 * The unit follows from the distance of the eyes, else from the best fit. Landmarks that no file gives are found by
 * laying the generic face over the scan (HeadFit.h, FaceRegistration.h). Each curve follows landmarks at the front and
 * runs evenly spaced at the back; its points lie where horizontal rays from an axis in the head leave the skin, at
 * azimuths t - 0.6 sin t with t = v - pi [Sheng et al. 2011, 4.1]. Ears are taken off, holes up to 30 mm are filled.
 * Lips are measured as closed. Tells its progress and can be aborted. Errors: a wrong landmark file (file and line), a
 * vertex the mesh does not have, a unit that cannot be told, no face, a mesh open where a curve runs, curves that would
 * cross; there is no output then.
 * @sa vtkScanReader vtkBoundaryCurveMeanFilter
 */
#ifndef vtkBoundaryCurveAcquisitionFilter_h
#define vtkBoundaryCurveAcquisitionFilter_h

#include <memory>  // for std::unique_ptr

#include "MienAcquisitionModule.h"
#include "vtkPolyDataAlgorithm.h"

namespace mien {
struct AcquiredScan;
}

class MIENACQUISITION_EXPORT vtkBoundaryCurveAcquisitionFilter : public vtkPolyDataAlgorithm {
 public:
  static vtkBoundaryCurveAcquisitionFilter* New();
  vtkTypeMacro(vtkBoundaryCurveAcquisitionFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Whether a scan is moved onto the generic face.
  enum Poses {
    AUTOMATIC = 0,  ///< upright heads stay where they are, others are moved onto the generic face
    KEPT = 1,
    MOVED = 2
  };

  ///@{
  /** CSV with the columns landmark, vertex or landmark, x, y, z (unit and frame of the scan); see LandmarkTable.h.
   * Default: none, the landmarks are found by fitting. */
  vtkSetFilePathMacro(LandmarkFileName);
  vtkGetFilePathMacro(LandmarkFileName);
  ///@}

  ///@{
  /** K, samples per curve. Default 40; even, 8 .. 4096. */
  vtkSetMacro(PointsPerCurve, int);
  vtkGetMacro(PointsPerCurve, int);
  ///@}

  ///@{
  /** Millimetres that one unit of the scan has, above 0. Default 0: recognised. */
  vtkSetMacro(Scale, double);
  vtkGetMacro(Scale, double);
  ///@}

  ///@{
  /** AUTOMATIC, KEPT or MOVED. Default AUTOMATIC. */
  vtkSetClampMacro(Pose, int, AUTOMATIC, MOVED);
  vtkGetMacro(Pose, int);
  ///@}

  ///@{
  /** Triangles to which the scan is decimated before it is measured, at least 1000. Default 0: it is not. */
  vtkSetMacro(Triangles, int);
  vtkGetMacro(Triangles, int);
  ///@}

  ///@{
  /** Whether parts of the scan that are neither its largest nor an eyeball count. Default off. */
  vtkSetMacro(AllParts, bool);
  vtkGetMacro(AllParts, bool);
  vtkBooleanMacro(AllParts, bool);
  ///@}

  ///@{
  /** Whether curves go into the nostrils where rays below the tip of the nose do, instead of from rim to rim. Default
   * off. */
  vtkSetMacro(Nostrils, bool);
  vtkGetMacro(Nostrils, bool);
  vtkBooleanMacro(Nostrils, bool);
  ///@}

  ///@{
  /** Whether landmarks from a file are compared with those found by fitting. Default off. */
  vtkSetMacro(CompareLandmarks, bool);
  vtkGetMacro(CompareLandmarks, bool);
  vtkBooleanMacro(CompareLandmarks, bool);
  ///@}

  /** What the last update found; empty before. */
  const mien::AcquiredScan& GetAcquired() const;

 protected:
  vtkBoundaryCurveAcquisitionFilter();
  ~vtkBoundaryCurveAcquisitionFilter() override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  vtkBoundaryCurveAcquisitionFilter(const vtkBoundaryCurveAcquisitionFilter&) = delete;
  void operator=(const vtkBoundaryCurveAcquisitionFilter&) = delete;

  std::string Measure(vtkPolyData* scan);
  std::string DescribeSettings() const;

  char* LandmarkFileName = nullptr;
  int PointsPerCurve = 40;
  double Scale = 0.0;
  int Pose = AUTOMATIC;
  int Triangles = 0;
  bool AllParts = false;
  bool Nostrils = false;
  bool CompareLandmarks = false;
  std::unique_ptr<mien::AcquiredScan> Acquired;
};

#endif
