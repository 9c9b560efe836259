#pragma once

#include <string>
#include <vector>

#include "FaceTemplate.h"
#include "HeadFit.h"
#include "LengthUnit.h"
#include "MeshCleaning.h"
#include "Progress.h"

namespace mien {

/// Where a face was found on a scan.
struct FoundFace {
  int part = 0;  ///< of the scan, counted by area
  LengthUnit unit;
  HeadFit fit;
};

/// What a search says that was stopped.
extern const char* const searchStopped;

/// "; say what its lengths are in with ..", with the scale that would make it a head where that is known, else 0.
std::string askForUnit(double millimetres);

/// The skin of one part, without eyeballs and stray pieces.
TriangleMesh partAlone(const TriangleMesh& mesh, const MeshParts& parts, int part);

/// The parts that are large enough beside the largest to be a head on a floor or in front of a wall, at most four.
std::vector<int> largeParts(const MeshParts& parts);

/// Lays the reference face over the largest part of a scan, in all units that its size allows (fitHead), and over the
/// next large ones where that holds no face.
/// @param millimetres  of the scan's unit; 0: recognised
/// @return nothing, or one sentence that says why there is none: of the largest part
std::string findFace(const TriangleMesh& scan, const MeshParts& parts, const FaceTemplate& reference,
                     double millimetres, FoundFace& found, const Progress& progress = {});

/// The unit of a scan of which no landmarks are known, as acquireScan recognises it: that in which one of its large
/// parts (largeParts) is as large as a head may be, and of several the one in which findFace finds the reference face.
/// A single one is told without that search, which then may still find no face.
/// @return nothing, or one sentence that says why it cannot be told; `fitting` are then those that the size allows
std::string recogniseScanUnit(const CleanMesh& scan, const FaceTemplate& reference, std::vector<LengthUnit>& fitting,
                              const Progress& progress = {});

}  // namespace mien
