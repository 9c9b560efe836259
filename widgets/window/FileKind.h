#pragma once

#include <QString>

namespace mien {

/// What a file holds, by its content rather than its name.
enum class FileKind {
  Animation,         ///< .fap, or a table of FAPs, action units or blendshapes; also what nobody else knows
  DeformationTable,  ///< facial deformation table, as text or packed
  AnimationTable,    ///< .json of what each FAP moves
  Session,           ///< .json of a window, or of the state of a face
  Curves,            ///< boundary curves of a face, .vtp or .mienz
  Scan,              ///< .ply .obj .stl .off
  Mesh,              ///< surface of VTK, .vtp or .vts
  Photograph,        ///< .png .jpg .tif
  PhotographMesh,    ///< warp mesh or landmarks of a photograph
  Landmarks,         ///< of a scan
  Markers,           ///< before and after an expression
  Json,              ///< .json of none of ours
  Other              ///< another kind of file
};

/// Looks at the beginning of a file; one that cannot be read is an Animation, whose reader says why.
FileKind fileKind(const QString& fileName);

}  // namespace mien
