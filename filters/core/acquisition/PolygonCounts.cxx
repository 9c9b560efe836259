#include "PolygonCounts.h"

#include <algorithm>
#include <vector>

#include "NumberText.h"
#include "PolygonFile.h"

namespace mien {

namespace {

void add(std::size_t corners, PolygonCounts& counts) {
  if (corners < 3) return;
  ++(corners == 3 ? counts.triangles : corners == 4 ? counts.quads : counts.larger);
}

/// "f 1/1/1 2/2/2 3/3/3 # a remark".
PolygonCounts countObj(std::string_view text) {
  PolygonCounts counts;
  std::vector<std::string_view> words;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    words.clear();
    std::string_view line = text.substr(begin, end - begin);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    splitAtBlanks(line, words);
    if (!words.empty() && words[0] == "f") {
      const auto remark = std::find_if(words.begin(), words.end(), [](auto word) { return word.front() == '#'; });
      add(static_cast<std::size_t>(remark - words.begin()) - 1, counts);
    }
    begin = end + 1;
  }
  return counts;
}

}  // namespace

PolygonCounts countPolygons(std::string_view text, const std::string& ending) {
  if (ending == ".obj") return countObj(text);
  PolygonCounts counts;
  PolygonFile file;
  if (!(ending == ".ply" ? file.openPly(text) : ending == ".off" && file.openOff(text))) return counts;
  double place[3];
  for (std::int64_t i = 0; i < file.vertexCount(); ++i)
    if (!file.readVertex(place)) return counts;
  std::vector<std::int64_t> corners;
  for (std::int64_t i = 0; i < file.faceCount() && file.readFace(corners); ++i) add(corners.size(), counts);
  return counts;
}

}  // namespace mien
