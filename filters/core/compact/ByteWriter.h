#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace mien {

/// Numbers as bytes, the same on every machine: little endian, whole numbers in as many bytes as they need.
class ByteWriter {
 public:
  void byte(std::uint8_t value) { bytes_.push_back(static_cast<char>(value)); }
  void whole(std::uint64_t value);         ///< seven bits per byte, the lowest first; the top bit says that more follow
  void signedWhole(std::int64_t value);    ///< 0, -1, 1, -2, 2 .. as the whole numbers 0, 1, 2, 3, 4 ..
  void fixed32(std::uint32_t value);       ///< four bytes
  void single(float value);                ///< IEEE 754, four bytes
  void text(std::string_view characters);  ///< its length, then its bytes

  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

}  // namespace mien
