#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace mien {

/// How the words of 4 bytes of a binary .off file lie: the numbers of vertices, faces and edges, the vertices, the
/// faces.
struct OffLayout {
  static constexpr std::size_t headerBytes = 12;

  bool isBigEndian = true;
  std::int64_t vertices = 0, faces = 0;
  int moreVertexWords = 0;  ///< behind x, y and z
  bool hasColourCounts =
      false;            ///< behind the corners of a face stands how many words of colour follow, as Geomview has it
  int colourWords = 0;  ///< behind the corners of every face
};

/// The layout with which the last face ends where the file does; the format itself does not say which it is: Geomview
/// writes big-endian numbers and counts of colours, others little-endian ones without.
///
/// @param body        what follows the line "OFF BINARY"
/// @param moreWords   of each vertex, its colour left out
/// @param hasColours  of the vertices: 3 or 4 words
std::optional<OffLayout> offLayoutOf(std::string_view body, int moreWords, bool hasColours);

}  // namespace mien
