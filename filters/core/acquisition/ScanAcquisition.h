#pragma once

#include <string>
#include <vector>

#include "FaceCurves.h"
#include "FaceSearch.h"
#include "FaceTemplate.h"
#include "LandmarkTable.h"
#include "LengthUnit.h"
#include "MeshCleaning.h"
#include "Progress.h"
#include "Similarity.h"

namespace mien {

/// How a scan is measured.
struct ScanSettings {
  enum class Pose {
    Automatic,  ///< a head that is upright within 10 degrees and near the origin stays where it is, others are moved
    Kept,
    Moved  ///< always onto the reference face
  };

  double millimetres = 0.0;  ///< of the scan's unit; 0: recognised
  Pose pose = Pose::Automatic;
  bool allParts = false;          ///< whether parts other than skin and eyeballs count
  bool nostrils = false;          ///< whether curves go into nostrils (acquireFace)
  bool compareLandmarks = false;  ///< whether given landmarks are compared with fitted ones
  int pointsPerCurve = 40;        ///< even, 8 or more
};

/// What was found on the way. Lengths in mm.
struct ScanReport {
  std::string unit;  ///< "mm", "cm", "m", "inch", or "" for a scale of one's own
  double millimetres = 1.0;
  bool unitRecognised = false;
  Similarity scanToFace;      ///< from the file's coordinates to those of the curves
  bool moved = false;         ///< whether the scan was turned and shifted
  double turned = 0.0;        ///< angle between the scan and the reference face, radians
  double eyes = 0.0;          ///< distance of the outer eye corners
  int facePart = 0;           ///< which part of the scan, counted by area, is the skin with the face
  bool windsInwards = false;  ///< the faces of the scan show their back: it is mirrored, or only wound so
  int mergedVertices = 0, degenerateTriangles = 0, parts = 0, droppedParts = 0, holes = 0, triangles = 0;
  bool landmarksGiven = false;
  int completedLandmarks = 0;
  bool fitted = false;                              ///< whether the reference face was laid over the scan
  double fitDistance = 0.0;                         ///< HeadFit::distance
  double fitRelief = 0.0;                           ///< HeadFit::relief
  double fitSize = 1.0;                             ///< of this head against the reference face
  double landmarkRMS = 0.0, landmarkMaximum = 0.0;  ///< between given and fitted landmarks, when both are known
  double landmarkDepth = 0.0;                       ///< median distance of the given landmarks to the scan
  std::string uncomparedReason;  ///< why given landmarks could not be compared with fitted ones, when they should be
};

/// The boundary curves of a scanned head and what they were measured on, in one frame (mm, +x the subject's left, +y
/// up, +z forward).
struct AcquiredScan {
  FaceCurves face;
  TriangleMesh mesh;
  FaceLandmarks landmarks;
  ScanReport report;
};

/// Measures a scan in any unit and pose: recognises the unit, places the landmarks that are not given, brings the head
/// into the frame of the reference face and measures the curves (acquireFace).
///
/// Without landmarks the reference face is laid over the largest part of the scan, or the next ones where that is no
/// head (findFace, registerFace).
/// Given landmarks must look like a face and lie on the scan.
/// @param given  which of `landmarks` (in the scan's unit and frame) are given; none: all are fitted
/// @return nothing, or one sentence that says what is wrong and what to do
std::string acquireScan(const CleanMesh& scan, const LandmarkTable::Given& given, const FaceLandmarks& landmarks,
                        const FaceTemplate& reference, const ScanSettings& settings, AcquiredScan& acquired,
                        const Progress& progress = {});

}  // namespace mien
