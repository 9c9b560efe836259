#pragma once

#include <string>
#include <vector>

#include "MienAcquisitionModule.h"
#include "Progress.h"
#include "ScanAcquisition.h"
#include "vtkSmartPointer.h"

class vtkPolyData;

/// What `mien acquire` does.
namespace mien {

/// What is measured, and where the results go.
struct AcquireOptions {
  std::vector<std::string> scans;  ///< .ply, .obj, .stl, .off; one, or several with `mean`
  std::string landmarkFile;    ///< CSV, see LandmarkTable.h; serves all scans; empty: landmarks are found by fitting
  std::string outputFile;      ///< .vtp
  std::string landmarkOutput;  ///< .csv for the landmarks in the scan's own frame and unit (with `mean` their symmetric
                               ///< mean in mm, in the frame of the curves); empty: none
  std::string scanOutput;      ///< .vtp for the scan in the frame of the curves; empty: none
  bool mean = false;           ///< the symmetric mean of all scans instead of one scan as it is
  bool report = false;         ///< whether distances are measured and landmarks compared
  int triangles = 0;           ///< decimation before measuring; 0: none
  ScanSettings scan;           ///< how each scan is measured
};

/// What was found on one scan.
struct AcquireResult {
  std::string scan;  ///< its file
  ScanReport report;
  int crossings = 0;           ///< of curves, between samples too
  std::string crossingCurves;  ///< which (namedCrossings)
  double frontalRMS = 0.0,
         frontalMaximum = 0.0;  ///< mm, of the spline face (a = 1, N = 5, 224 x 160, z > 50 mm) to the scan
};

/// A scan that was measured and not written.
struct MeasuredScan {
  AcquireResult result;
  FaceLandmarks landmarks;
  vtkSmartPointer<vtkPolyData> curves;  ///< as in BoundaryCurveData.h, mm
  vtkSmartPointer<vtkPolyData> scan;    ///< cleaned, in mm, in the frame of the curves
};

/// Reads one scan and measures it with these options, of which files to write and other scans do not count.
/// @return nothing, or "FILE[:LINE]: what is wrong and what to do"
MIENACQUISITION_EXPORT std::string measureScan(const AcquireOptions& options, const std::string& file,
                                               MeasuredScan& measured, const Progress& progress = {});

/// What was found, in lines of text: unit, pose, mesh, landmarks, fit, distance, crossings.
MIENACQUISITION_EXPORT std::string reportText(const AcquireResult& result);

/// The 4 x 4 matrix from the scan's coordinates to those of the curves, in four more lines.
MIENACQUISITION_EXPORT std::string matrixText(const ScanReport& report);

/// Reads the scans, measures their boundary curves and writes them as XML polydata (inline, not compressed).
/// @return nothing, or "FILE[:LINE]: what is wrong and what to do"; no curves are written then
MIENACQUISITION_EXPORT std::string acquire(const AcquireOptions& options, std::vector<AcquireResult>* results = nullptr,
                                           const Progress& progress = {});

}  // namespace mien
