#pragma once

#include <string_view>

namespace mien {

/// CRC-32 (ISO 3309) of the bytes.
unsigned checksumOf(std::string_view bytes);

}  // namespace mien
