#include "StlText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>
#include <unordered_map>
#include <vector>

#include "LineCutter.h"
#include "MeshBuilder.h"
#include "NumberText.h"
#include "SmallLetters.h"
#include "VertexWords.h"

namespace mien {

namespace {

constexpr std::size_t stlTitle = 80, stlHeader = 84, stlTriangle = 50, stlNormal = 12;  // bytes

/// Multilinear hash of a place's six words of 32 bits with keys drawn anew for every file, so that no file can be made
/// whose places collide (Dietzfelbinger 1996); vertices are numbered as they come, whatever the keys.
class PlaceHash {
 public:
  PlaceHash() {
    std::random_device random;
    for (std::uint64_t& key : keys_) key = static_cast<std::uint64_t>(random()) << 32 | random();
  }

  std::size_t operator()(const std::array<double, 3>& place) const {
    std::uint64_t sum = keys_[6];
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = place[i] + 0.0;  // -0 becomes 0
      std::uint64_t bits;
      std::memcpy(&bits, &x, sizeof bits);
      sum += keys_[2 * i] * (bits >> 32) + keys_[2 * i + 1] * (bits & 0xffffffff);
    }
    return static_cast<std::size_t>(sum >> 32);
  }

 private:
  std::array<std::uint64_t, 7> keys_;
};

/// The mesh of corners that come three by three, those at the same place being one vertex.
class Corners {
 public:
  void add(const double (&place)[3]) {
    const auto [entry, isNew] = vertices_.try_emplace({place[0], place[1], place[2]}, mesh_.vertexCount());
    if (isNew) mesh_.addVertex(place);
    triangle_[corner_++ % 3] = entry->second;
    if (corner_ % 3 > 0) return;
    mesh_.count(3);
    mesh_.addTriangle(triangle_[0], triangle_[1], triangle_[2]);
  }

  std::optional<MeshFault> finish(MeshText& read) const { return mesh_.finish(read); }

 private:
  MeshBuilder mesh_;
  std::unordered_map<std::array<double, 3>, std::int64_t, PlaceHash> vertices_;
  std::int64_t triangle_[3] = {};
  std::size_t corner_ = 0;
};

class StlWords {
 public:
  /// @return nothing, or what is wrong
  std::string read(const std::vector<std::string_view>& words, Corners& corners) {
    std::string first = inSmallLetters(words[0]);
    if (first == "end" && words.size() > 1) first += inSmallLetters(words[1]);
    if (first == "solid" || first == "facet") ended = false;
    if (ended) return {};
    ended = first == "endsolid";
    if (first == "outer") loop_.clear();
    if (first == "vertex") {
      loop_.emplace_back();
      return readVertexWords(words, loop_.back().place);
    }
    if (first != "endloop") return {};
    if (loop_.size() != 3) return "a facet of " + std::to_string(loop_.size()) + " corners";
    for (const Corner& corner : loop_) corners.add(corner.place);
    return {};
  }

  bool ended = false;

 private:
  struct Corner {
    double place[3];
  };
  std::vector<Corner> loop_;
};

std::optional<MeshFault> readStlLines(std::string_view text, MeshText& read) {
  Corners corners;
  StlWords facets;
  std::vector<std::string_view> words;
  LineCutter lines(text);
  for (std::string_view line; lines.next(line);) {
    splitAtBlanks(line, words);
    if (words.empty()) continue;
    const std::string fault = facets.read(words, corners);
    if (!fault.empty()) return MeshFault{lines.number(), fault + exportMeshAgain};
  }
  if (!facets.ended)
    return MeshFault{std::max(1, lines.number()), std::string("the file ends without endsolid") + exportMeshAgain};
  return corners.finish(read);
}

std::uint32_t littleEndian(const char* bytes) {
  unsigned char b[4];
  std::memcpy(b, bytes, 4);
  return b[0] | b[1] << 8 | b[2] << 16 | static_cast<std::uint32_t>(b[3]) << 24;
}

double littleEndianReal(const char* bytes) {
  const std::uint32_t bits = littleEndian(bytes);
  float number;
  std::memcpy(&number, &bits, 4);
  return number;
}

std::optional<MeshFault> readStlBytes(std::string_view text, MeshText& read) {
  if (text.size() < stlHeader)
    return MeshFault{0, std::string("the file ends within its header of 84 bytes") + exportMeshAgain};
  const std::size_t count = littleEndian(text.data() + stlTitle);
  Corners corners;
  for (std::size_t t = 0; t < count; ++t) {
    const auto fault = [&](const std::string& what) {
      return MeshFault{
          0, "triangle " + std::to_string(t + 1) + " of " + std::to_string(count) + " " + what + exportMeshAgain};
    };
    if (text.size() < stlHeader + stlTriangle * (t + 1)) return fault("is not there");
    const char* bytes = text.data() + stlHeader + stlTriangle * t + stlNormal;
    for (int corner = 0; corner < 3; ++corner) {
      double place[3];
      for (double& x : place) x = littleEndianReal(bytes), bytes += 4;
      if (!std::isfinite(place[0] + place[1] + place[2]))
        return fault("has a corner that is not made of finite numbers");
      corners.add(place);
    }
  }
  return corners.finish(read);
}

bool hasWord(std::string_view text, std::string_view small) {
  const auto isSame = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; };
  return std::search(text.begin(), text.end(), small.begin(), small.end(), isSame) != text.end();
}

/// Letters in the place of the number of triangles promise more than any text holds.
bool fitsBytes(std::string_view text) {
  if (text.size() < stlHeader) return false;
  const std::uint64_t count = littleEndian(text.data() + stlTitle);
  return count > 0 && stlHeader + stlTriangle * count <= text.size();
}

bool hasControlBytes(std::string_view text) {
  const auto isControl = [](char c) { return (c >= 0 && c < 9) || (c > 13 && c < 32); };
  return std::any_of(text.begin(), text.end(), isControl);
}

}  // namespace

std::optional<MeshFault> readStlText(std::string_view text, MeshText& read) {
  if (fitsBytes(text)) return readStlBytes(text, read);
  const std::string_view written = text.substr(0, text.find_last_not_of('\0') + 1);  // some pad their text to blocks
  if (hasWord(written, "facet") && hasWord(written, "vertex")) return readStlLines(written, read);
  if (hasControlBytes(written) || (text.size() >= stlHeader && littleEndian(text.data() + stlTitle) == 0))
    return readStlBytes(text, read);
  return MeshFault{0,
                   "this is no STL file (it is text without a vertex); export the scan again, or give the file its "
                   "right ending"};
}

}  // namespace mien
