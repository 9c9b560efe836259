#include "ByteWriter.h"

#include <cstring>

namespace mien {

void ByteWriter::whole(std::uint64_t value) {
  for (; value >= 0x80; value >>= 7) byte(static_cast<std::uint8_t>(value | 0x80));
  byte(static_cast<std::uint8_t>(value));
}

void ByteWriter::signedWhole(std::int64_t value) {
  const auto twice = static_cast<std::uint64_t>(value) << 1;
  whole(value < 0 ? ~twice : twice);
}

void ByteWriter::fixed32(std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) byte(static_cast<std::uint8_t>(value >> shift));
}

void ByteWriter::single(float value) {
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  fixed32(bits);
}

void ByteWriter::text(std::string_view characters) {
  whole(characters.size());
  bytes_ += characters;
}

}  // namespace mien
