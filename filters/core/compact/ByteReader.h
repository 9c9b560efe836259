#pragma once

#include <cstdint>
#include <string_view>

namespace mien {

/// Reads what ByteWriter wrote, from bytes that are not trusted: past their end, or at a number too long to be one,
/// everything reads as 0 and good() is false from then on.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  std::uint8_t byte();
  std::uint64_t whole();
  std::int64_t signedWhole();
  std::uint32_t fixed32();
  float single();
  std::string_view text();  ///< within the bytes

  bool good() const { return good_; }
  std::string_view rest() const { return rest_; }

 private:
  std::string_view take(std::uint64_t count);

  std::string_view rest_;
  bool good_ = true;
};

}  // namespace mien
