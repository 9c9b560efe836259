#include "StlText.h"

#include <array>
#include <cmath>
#include <cstring>
#include <functional>
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

struct PlaceHash {
  std::size_t operator()(const std::array<double, 3>& place) const {
    std::size_t hash = 0;
    for (const double x : place) hash = hash * 1000003 + std::hash<double>()(x);  // 0 and -0 have the same
    return hash;
  }
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
    const std::string first = inSmallLetters(words[0]);
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

}  // namespace

bool isTextStl(std::string_view text) {
  return inSmallLetters(text.substr(0, 5)) == "solid" && text.find('\0') == std::string_view::npos;
}

std::optional<MeshFault> readStlText(std::string_view text, MeshText& read) {
  return isTextStl(text) ? readStlLines(text, read) : readStlBytes(text, read);
}

}  // namespace mien
