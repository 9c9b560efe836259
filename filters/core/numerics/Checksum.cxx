#include "Checksum.h"

#include <lzma.h>

#include <charconv>

namespace mien {

unsigned checksumOf(std::string_view bytes) {
  return lzma_crc32(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(), 0);
}

std::uint64_t hashOf(std::string_view bytes) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211u;
  return hash;
}

std::string hashText(std::string_view bytes) {
  char digits[16];
  const auto result = std::to_chars(digits, digits + sizeof digits, hashOf(bytes), 16);
  const std::string text(digits, result.ptr);
  return std::string(sizeof digits - text.size(), '0') + text;
}

}  // namespace mien
