#pragma once

#include <memory>
#include <string>

#include "FaceState.h"
#include "MienAnimationModule.h"

class vtkAlgorithm;
class vtkBoundaryCurveReader;
class vtkFAPAnimationFilter;
class vtkFAPReader;
class vtkPDEFaceFilter;
class vtkStructuredGrid;

namespace mien {

/// The VTK pipeline that shows a FaceState, for every program:
///   vtkBoundaryCurveReader --> vtkCurveEditFilter --> vtkFAPAnimationFilter --> vtkPDEFaceFilter -->
///     (vtkFDTDeformationFilter) --> vtkGeometryFilter; the animated curves --> (vtkFDTCurveFilter) to be looked at
///   vtkFAPReader (when there is a file) to the animation, vtkFDTReader (when there is a table) to the deformation
///
/// Setting a state touches only the filters whose properties differ, so that the next update does no more than it must.
/// Errors are kept, not printed: update() returns them.
class MIENANIMATION_EXPORT FacePipeline {
 public:
  FacePipeline();
  ~FacePipeline();
  FacePipeline(const FacePipeline&) = delete;
  FacePipeline& operator=(const FacePipeline&) = delete;

  void setState(const FaceState& state);
  const FaceState& state() const;

  vtkBoundaryCurveReader* neutralCurves() const;  ///< as read, before edits
  vtkFAPReader* frames() const;                   ///< the animation file's; empty until a state with a file was updated
  vtkFAPAnimationFilter* animation() const;
  vtkAlgorithm* curves() const;       ///< vtkPolyData, the boundary curves as animated, from which the surface is made
  vtkAlgorithm* shownCurves() const;  ///< the same as the table leaves them
  vtkPDEFaceFilter* face() const;     ///< vtkStructuredGrid with the mouth slit blanked, before any table
  vtkStructuredGrid* grid() const;    ///< the same as the table leaves it; brought up to date by update(), updateGrid()
  vtkAlgorithm* surface()
      const;  ///< vtkPolyData for mappers, locators and writers: without the slit; wound inwards as the grid

  /// Reads the curves, and what the animation file holds; what is wrong with the files, or nothing.
  std::string updateNeutralCurves();

  /// After updateNeutralCurves(): which property of the state does not fit the curves or the animation file, and what
  /// is allowed; or nothing.
  std::string describeValueFault();

  /// Points per curve (K) after updateNeutralCurves(), 0 without curves.
  int pointsPerCurve() const;

  /// Brings the curves up to date, animated and shown; the first error on the way as one sentence, or nothing.
  std::string updateCurves();

  /// Brings the grid up to date but not the polygons of surface(); the first error on the way, or nothing.
  std::string updateGrid();

  /// Brings the surface and the shown curves up to date; the first error on the way as one sentence, or nothing.
  std::string update();

 private:
  struct Internals;
  std::unique_ptr<Internals> Impl;
};

}  // namespace mien
