#pragma once

#include <optional>
#include <string_view>

#include "FAPLineParser.h"
#include "FAPSequence.h"
#include "FacialActionMap.h"

namespace mien {

/// What the columns of a capture table are.
enum class CaptureKind { ActionUnits, Blendshapes };

/// Reads facial capture as a table with a header (CommaReader.h) and gives it as FAPs:
///   FAP value = sum over the columns of strength x value of the map, strength = cell / full, within 0 .. 1.
/// Action units are named as in ActionUnitName.h: OpenFace's intensities are full at 5, others at 1, or at 5 when most
/// of them exceeds 1. Blendshapes are ARKit's, in any spelling; full at 1, or at 100 when most moving ones exceed 2 and
/// one 5; another scale than 1 is said. Rotations are in rad; those of the eyes count where no eyeLook shape moves.
/// Time: a `timecode` (TimeCode.h), else `time` or `timestamp` in s, else 25 frames per second with a warning. Rows in
/// which the face was lost (success 0, no blendshapes, empty cells) are left out and bridged; of several faces the
/// first counts. Refused: no column of the kind, a cell that is no number, a row of another length, time that goes
/// back.
/// @return the error, and then `sequence` is as it was; or nothing
std::optional<FAPParseError> parseCapture(std::string_view text, CaptureKind kind, const FacialActionMap& map,
                                          FAPSequence& sequence);

}  // namespace mien
