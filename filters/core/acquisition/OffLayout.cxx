#include "OffLayout.h"

#include <algorithm>

namespace mien {

namespace {

constexpr std::size_t wordBytes = 4;

class OffWords {
 public:
  OffWords(std::string_view bytes, bool isBigEndian) : bytes_(bytes), isBigEndian_(isBigEndian) {}

  std::size_t left() const { return bytes_.size() / wordBytes - at_; }

  bool skip(std::uint64_t words) {
    if (words > left()) return false;
    at_ += static_cast<std::size_t>(words);
    return true;
  }

  bool next(std::uint64_t& word) {
    if (left() == 0) return false;
    word = 0;
    for (std::size_t i = 0; i < wordBytes; ++i)
      word |= static_cast<std::uint64_t>(byte(i)) << 8 * (isBigEndian_ ? wordBytes - 1 - i : i);
    ++at_;
    return true;
  }

  /// A line end behind the last word is none.
  bool ended() const {
    return left() == 0 && bytes_.find_first_not_of("\r\n", at_ * wordBytes) == std::string_view::npos;
  }

 private:
  unsigned char byte(std::size_t i) const { return static_cast<unsigned char>(bytes_[at_ * wordBytes + i]); }

  std::string_view bytes_;
  bool isBigEndian_;
  std::size_t at_ = 0;
};

bool endsWithFile(std::string_view body, OffLayout& layout) {
  OffWords words(body, layout.isBigEndian);
  std::uint64_t vertices, faces, edges, count;
  if (!words.next(vertices) || !words.next(faces) || !words.next(edges)) return false;
  if (!words.skip(vertices * static_cast<std::uint64_t>(3 + layout.moreVertexWords))) return false;
  for (std::uint64_t face = 0; face < faces; ++face) {
    if (!words.next(count) || !words.skip(count)) return false;
    if (layout.hasColourCounts && !(words.next(count) && words.skip(count))) return false;
    if (!words.skip(static_cast<std::uint64_t>(layout.colourWords))) return false;
  }
  layout.vertices = static_cast<std::int64_t>(vertices);
  layout.faces = static_cast<std::int64_t>(faces);
  return words.ended();
}

}  // namespace

std::optional<OffLayout> offLayoutOf(std::string_view body, int moreWords, bool hasColours) {
  for (const bool isBigEndian : {true, false})
    for (const int more : {moreWords + (hasColours ? 4 : 0), moreWords + (hasColours ? 3 : 0)})
      for (const int colourWords : {-1, 0, 3, 4}) {
        OffLayout layout{isBigEndian, 0, 0, more, colourWords < 0, std::max(0, colourWords)};
        if (endsWithFile(body, layout)) return layout;
      }
  return std::nullopt;
}

}  // namespace mien
