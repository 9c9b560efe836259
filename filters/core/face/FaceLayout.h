#pragma once

#include <array>
#include <string>

namespace mien {

/// How 29 boundary curves bound nine patches [S 4.1].
///
/// Curves are stored C1 .. C22, C22', C23 .. C28 (index 0 .. 28). C22 and C22' are the inner contours
/// of the upper and the lower lip; patches P0 .. P6 lie above the mouth, P7 and P8 below it.
namespace FaceLayout {

constexpr int curveCount = 29;
constexpr int patchCount = 9;
constexpr int curvesPerPatch = 4;
constexpr int upperLip = 21;  ///< index of C22
constexpr int lowerLip = 22;  ///< index of C22'

/// Index of the first of the four consecutive curves of each patch.
constexpr std::array<int, patchCount> firstCurve = {0, 3, 6, 9, 12, 15, 18, 22, 25};

/// "C1" .. "C22", "C22'", "C23" .. "C28".
std::string curveName(int index);

/// The CurveId of the file format: 1 .. 28, and 29 for C22'.
int curveId(int index);

/// Index of a name or -1; "c22'" and "C22p" are understood as well.
int curveIndex(const std::string& name);

}  // namespace FaceLayout

}  // namespace mien
