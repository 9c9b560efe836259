#pragma once

#include <string>

#include "FaceState.h"

namespace mien {

/// Text form of a FaceState: a JSON object with the members
/// - `mien_face_state`: the version, 2;
/// - `curves`: file name, left out for the generic face;
/// - `edits`: list of `curve` (name), `v` (radians), `move` (three numbers, mm), `width` (radians), `spread`,
/// `mirrored`; left out without one;
/// - `surface`: `scheme`, `a` (nine numbers), `harmonics`, `remainder`, `derivative_strength`;
/// - `grid`: `rows`, `columns`, `uniform_rows`, `precision` ("single" or "double");
/// - `animation`: `file`, one of `frame`, `index`, `time` (s), and `interpolate`; left out without a file;
/// - `fap_values`: FAP number to FAP units;
/// - `animation_table`: file name, left out for the table compiled in;
/// - `expressions`, `visemes`: name to intensity (0 .. 1); each left out without one;
/// - `deformation`: `table` (name or file), `strength`, `smooth`; left out without a table;
/// - `texture`: `image` (file name) and `mesh` (file name, left out for the one beside the image); left out without an
/// image. Numbers are written so that they read back to the bit. A member left out has its default.
constexpr int faceStateVersion = 2;

std::string writeFaceState(const FaceState& state);  ///< as described above

/// @return nothing, or one sentence that names the member at fault; the state is then as it was. A member that this
/// version does not know is a fault, because to drop it would show another face.
std::string readFaceState(const std::string& text, FaceState& state);

}  // namespace mien
