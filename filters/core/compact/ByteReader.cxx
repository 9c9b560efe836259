#include "ByteReader.h"

#include <cstring>

namespace mien {

std::string_view ByteReader::take(std::uint64_t count) {
  good_ = good_ && count <= rest_.size();
  if (!good_) return {};
  const std::string_view taken = rest_.substr(0, static_cast<std::size_t>(count));
  rest_.remove_prefix(taken.size());
  return taken;
}

std::uint8_t ByteReader::byte() {
  const std::string_view taken = take(1);
  return taken.empty() ? 0 : static_cast<std::uint8_t>(taken[0]);
}

std::uint64_t ByteReader::whole() {
  constexpr int longest = 63;  // bits; nothing that is written needs the 64th
  std::uint64_t value = 0;
  for (int shift = 0; shift < longest; shift += 7) {
    const std::uint8_t next = byte();
    value |= static_cast<std::uint64_t>(next & 0x7f) << shift;
    if (next < 0x80) return value;
  }
  good_ = false;
  return 0;
}

std::int64_t ByteReader::signedWhole() {
  const std::uint64_t twice = whole();
  const auto half = static_cast<std::int64_t>(twice >> 1);
  return twice & 1 ? ~half : half;
}

std::uint32_t ByteReader::fixed32() {
  std::uint32_t value = 0;
  for (int shift = 0; shift < 32; shift += 8) value |= static_cast<std::uint32_t>(byte()) << shift;
  return value;
}

float ByteReader::single() {
  const std::uint32_t bits = fixed32();
  float value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

std::string_view ByteReader::text() {
  return take(whole());
}

}  // namespace mien
