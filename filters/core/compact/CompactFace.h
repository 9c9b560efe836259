#pragma once

#include <string>
#include <string_view>

#include "FaceCurves.h"

namespace mien {

/// A face as a compact face file (.mienz) holds it, and how far its curves lie from those that were stored.
struct CompactFace {
  FaceCurves face;        ///< curves as they come back from the file; feature points to 0.0001 rad, pupils to 0.01 mm
  std::string name;       ///< may be empty
  double rmsError = 0.0;  ///< mm, over the 29 K points
  double maximumError = 0.0;  ///< mm
};

/// Limits of the format.
struct CompactFaceLimits {
  static constexpr int version = 1;
  static constexpr int smallestCurve = 8, largestCurve = 4096;  ///< points, even
  static constexpr double finest = 1e-6, coarsest = 100.0;      ///< tolerance, mm
  static constexpr double farthest = 1e4;                       ///< coordinate, mm
  static constexpr std::size_t longestName = 255, longestId = 32, mostFeatures = 1000;
  static constexpr std::size_t largestFile = std::size_t(4) << 20;  ///< bytes
};

/// Stores a face with the largest quantisation step at which its points lie within `tolerance` (mm, RMS over the 29 K
/// points) of the given ones.
///
/// The bytes, little endian: "MIENZ", version, CRC-32 of all that follows; unit (0: mm), flags (1: pupils); step, RMS
/// error and largest error (mm, single precision); K, name, number of feature points (whole numbers as in ByteWriter);
/// then, packed (EntropyCode), feature points, pupils and levels (CurveCoder). [S 7] counts 13,920 bytes for K = 40.
/// @return nothing, or one sentence that says what cannot be stored
std::string encodeCompactFace(const FaceCurves& face, const std::string& name, double tolerance, std::string& bytes);

/// Whether bytes begin as a compact face file does.
bool isCompactFace(std::string_view bytes);

/// Reads bytes that are not trusted; what comes back is a sound face.
/// @return nothing, or one sentence that says what is wrong and what to do; `compact` is then left alone
std::string decodeCompactFace(std::string_view bytes, CompactFace& compact);

}  // namespace mien
