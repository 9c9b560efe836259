#pragma once

#include <string>
#include <vector>

#include "EyePupils.h"
#include "HeadRotation.h"
#include "MienDeformationModule.h"
#include "Progress.h"
#include "PupilNormalisation.h"
#include "TableDeformation.h"

class vtkPointSet;
class vtkStringArray;

namespace mien {

/// Where a face's pupils are to be looked for.
struct FaceFrameOptions {
  Eigen::Vector3d leftPupil = Eigen::Vector3d::Zero();  ///< by hand when the two differ
  Eigen::Vector3d rightPupil = Eigen::Vector3d::Zero();
  std::string leftPupilName = "pupil_left",
              rightPupilName = "pupil_right";  ///< points of these names in the point array `marker`
  std::string landmarkFile;                    ///< CSV of the 68 landmarks (LandmarkTable.h)
  bool turnsToFront = true;  ///< whether a mesh that looks aside by its landmarks is read as if it looked along +z
};

/// A point set as a face: pupils, head rotation, and where its points lie.
struct FaceFrame {
  PupilNormalisation pupils;
  EyePupils places;     ///< the pupils, in the data's own unit and frame
  HeadRotation turned;  ///< of field array `HeadRotation`; pupils and points below are in the head's own frame
  bool isMesh = false;  ///< whether there are polygons: only what is in front belongs to the face then
  std::string warning;  ///< one sentence that says what will not come out right, or nothing
  std::vector<DeformationPoint> points;
};

/// Finds the pupils: those set by hand, else points named so, else field array `Pupils` (2 x 3, left then right), else
/// those of the landmarks (EyePupils.h).
/// @return nothing, or one sentence that says what is missing or wrong
MIENDEFORMATION_EXPORT std::string readPupils(vtkPointSet* data, const FaceFrameOptions& options, FaceFrame& frame);

/// readPupils(), and for every point its place in the head's frame and its sides: point arrays `LipSide` and `LidSide`,
/// else by u on a PDE face (a structured grid with `PatchId`), by distance along the surface on a mesh with landmarks,
/// or by the number of points named landmarkNN in the point array `marker`. Regions are those of the point array
/// `region` (1 .. 16, 0: by place). Eyes of a mesh stay where they are: what EyeShells.h finds, and with landmarks
/// EyePupils.h. A mesh whose landmarks look more than 10 degrees away from +z is turned to look there (`turned`) with a
/// warning; more than 45, backwards and mirrored ones are refused. One without landmarks is judged by its pupils
/// (FaceFront.h, FacePosture.h), and gets a warning when these look aside. When `progress` says stop, what is returned
/// is a sentence too.
MIENDEFORMATION_EXPORT std::string readFaceFrame(vtkPointSet* data, const FaceFrameOptions& options,
                                                 const FacialRegions& regions, FaceFrame& frame,
                                                 const Progress& progress = {});

/// The point array `marker`, which names the points; nothing without it.
MIENDEFORMATION_EXPORT vtkStringArray* markerNames(vtkPointSet* data);

/// A region map from a file; the compiled in one without a name. @return nothing, or `FILE: what is wrong`
MIENDEFORMATION_EXPORT std::string readRegions(const std::string& file, FacialRegions& regions);

}  // namespace mien
