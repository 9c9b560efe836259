#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace mien {

/// CRC-32 (ISO 3309) of the bytes.
unsigned checksumOf(std::string_view bytes);

/// FNV-1a of 64 bits (Fowler, Noll and Vo): tells many texts apart where CRC-32 would have two alike.
std::uint64_t hashOf(std::string_view bytes);

/// That as 16 hexadecimal digits.
std::string hashText(std::string_view bytes);

}  // namespace mien
