#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace mien {

/// Bytes in fewer bytes: LZMA without container (liblzma's raw coder), whose adaptive range coder beats Brotli, zstd
/// and zlib on the one or two kilobytes of a face (doc/decisions.md).
std::string packBytes(std::string_view bytes);

/// @param limit  refuses to unpack more bytes than that
/// @return whether `packed` is whole and unpacks to at most `limit` bytes; `bytes` is left alone otherwise
bool unpackBytes(std::string_view packed, std::size_t limit, std::string& bytes);

}  // namespace mien
