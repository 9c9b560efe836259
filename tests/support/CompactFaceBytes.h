#pragma once

#include <cmath>
#include <string>

#include "ByteWriter.h"
#include "Checksum.h"
#include "EntropyCode.h"

/// A compact face file put together by hand, with the right checksum whatever is in it.
struct CompactFaceBytes {
  int version = 1, unit = 0, flags = 0;
  float step = 0.1f, rms = 0.1f, maximum = 0.2f;
  std::uint64_t points = 40, features = 0;
  std::string name;
  std::string body = std::string(9, '\x02');  ///< before it is packed: features, pupils, levels
  bool packed = true;

  std::string bytes() const {
    mien::ByteWriter header, start;
    header.byte(static_cast<std::uint8_t>(unit));
    header.byte(static_cast<std::uint8_t>(flags));
    for (const float value : {step, rms, maximum}) header.single(value);
    header.whole(points);
    header.text(name);
    header.whole(features);
    return closed(version, header.bytes() + (packed ? mien::packBytes(body) : body));
  }

  /// With magic, version and checksum before any content.
  static std::string closed(int version, const std::string& checked) {
    mien::ByteWriter start;
    start.byte(static_cast<std::uint8_t>(version));
    start.fixed32(mien::checksumOf(checked));
    return "MIENZ" + start.bytes() + checked;
  }

  template <class Change>
  static std::string with(const Change& change) {
    CompactFaceBytes face;
    change(face);
    return face.bytes();
  }
};
