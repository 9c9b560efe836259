#include "Checksum.h"

#include <lzma.h>

namespace mien {

unsigned checksumOf(std::string_view bytes) {
  return lzma_crc32(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(), 0);
}

}  // namespace mien
