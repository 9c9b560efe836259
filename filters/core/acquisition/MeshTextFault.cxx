#include "MeshTextFault.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "NumberText.h"
#include "PolygonFile.h"

namespace mien {

namespace {

constexpr const char* exportAgain = "; the file is damaged, export the scan again";

/// Faces with a corner that is no vertex: how many, and the first.
struct LostFaces {
  std::int64_t count = 0, corner = 0;
  std::string place;

  void note(const std::string& where, std::int64_t asked) {
    if (count++ > 0) return;
    place = where;
    corner = asked;
  }

  std::string describe(std::int64_t vertices) const {
    if (count == 0) return {};
    return place + ": a face has the corner " + std::to_string(corner) + ", but there are " +
           (vertices == 1 ? "1 vertex" : std::to_string(vertices) + " vertices") +
           (count > 1 ? " (" + std::to_string(count) + " faces are like that)" : "") + exportAgain;
  }
};

std::string lineNumber(std::int64_t line) {
  return "line " + std::to_string(line);
}

std::string describeVertex(const std::string& place) {
  return place + ": a vertex that is not a finite number" + exportAgain;
}

/// Calls `use` with every line, its number and its words, until it returns false.
template <class Use>
void forLines(std::string_view text, Use use) {
  std::vector<std::string_view> words;
  std::int64_t line = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view part = text.substr(begin, end - begin);
    if (!part.empty() && part.back() == '\r') part.remove_suffix(1);
    words.clear();
    splitAtBlanks(part, words);
    if (!use(++line, words)) return;
    begin = end + 1;
  }
}

bool areNumbers(const std::vector<std::string_view>& words, std::size_t first) {
  if (words.size() < first + 3) return false;
  for (std::size_t i = first; i < first + 3; ++i)
    if (!parseNumber(words[i])) return false;
  return true;
}

/// "v x y z" and "f 1/1/1 2/2/2 3/3/3", counted from 1, or from the last vertex so far where negative.
class ObjCheck {
 public:
  std::string describe(std::string_view text) {
    std::string fault;
    forLines(text, [&](std::int64_t, const std::vector<std::string_view>& words) {
      if (!words.empty() && words[0] == "v") ++vertices_;
      return true;
    });
    forLines(text, [&](std::int64_t line, const std::vector<std::string_view>& words) {
      if (words.empty()) return true;
      if (words[0] == "v") {
        ++soFar_;
        if (!areNumbers(words, 1)) fault = describeVertex(lineNumber(line));
      } else if (words[0] == "f") {
        checkFace(line, words);
      }
      return fault.empty();
    });
    return fault.empty() ? lost_.describe(vertices_) : fault;
  }

 private:
  void checkFace(std::int64_t line, const std::vector<std::string_view>& words) {
    for (std::size_t i = 1; i < words.size(); ++i) {
      if (words[i].front() == '#' || words[i] == "\\") return;
      const auto corner = parseWholeNumber(words[i].substr(0, words[i].find('/')));
      if (!corner) return;  // for the reader to refuse
      if (*corner >= 1 ? *corner <= vertices_ : *corner < 0 && *corner >= -soFar_) continue;
      lost_.note(lineNumber(line), *corner);
      return;
    }
  }

  std::int64_t vertices_ = 0, soFar_ = 0;
  LostFaces lost_;
};

/// Of the polygons of .ply and .off.
std::string describePolygons(PolygonFile& file) {
  LostFaces lost;
  const auto countOf = [](std::int64_t i, std::int64_t count) {
    return std::to_string(i + 1) + " of " + std::to_string(count);
  };
  for (std::int64_t i = 0; i < file.vertexCount(); ++i) {
    double place[3];
    if (!file.readVertex(place))
      return file.lineHere() + "vertex " + countOf(i, file.vertexCount()) + " is not there, or is not made of numbers" +
             exportAgain;
    for (const double number : place)
      if (!(number - number == 0.0)) return describeVertex(file.place("vertex", i));
  }
  std::vector<std::int64_t> corners;
  for (std::int64_t i = 0; i < file.faceCount(); ++i) {
    if (!file.readFace(corners))
      return file.lineHere() + "face " + countOf(i, file.faceCount()) + " is not there, or is no list of corners" +
             exportAgain;
    for (const std::int64_t corner : corners)
      if (corner < 0 || corner >= file.vertexCount()) {
        lost.note(file.place("face", i), corner);
        break;
      }
  }
  return lost.describe(file.vertexCount());
}

/// "vertex x y z", three of them in each "outer loop" .. "endloop", "endsolid" at the end.
class StlCheck {
 public:
  std::string describe(std::string_view text) {
    std::string fault;
    std::int64_t last = 1;
    forLines(text, [&](std::int64_t line, const std::vector<std::string_view>& words) {
      last = line;
      if (!words.empty()) fault = check(words);
      return fault.empty();
    });
    if (fault.empty() && !ended_) fault = "the file ends without endsolid";
    return fault.empty() ? fault : lineNumber(last) + ": " + fault + exportAgain;
  }

 private:
  std::string check(const std::vector<std::string_view>& words) {
    ended_ = words[0] == "endsolid";
    if (words[0] == "vertex" && !areNumbers(words, 1)) return "a vertex that is not a finite number";
    if (words[0] == "outer") corners_ = 0;
    if (words[0] == "vertex") ++corners_;
    if (words[0] == "endloop" && corners_ != 3) return "a facet of " + std::to_string(corners_) + " corners";
    return {};
  }

  int corners_ = 0;
  bool ended_ = false;
};

bool isTextStl(std::string_view text) {
  return text.substr(0, 5) == "solid" && text.find("facet") != std::string_view::npos &&
         text.find('\0') == std::string_view::npos;
}

}  // namespace

std::string describeMeshTextFault(std::string_view text, const std::string& ending) {
  if (ending == ".obj") return ObjCheck().describe(text);
  if (ending == ".stl") return isTextStl(text) ? StlCheck().describe(text) : std::string();
  if (ending != ".ply" && ending != ".off") return {};
  PolygonFile file;
  if (ending == ".ply" ? file.openPly(text) : file.openOff(text)) return describePolygons(file);
  return "the header does not say how many vertices there are, or of what they are made" + std::string(exportAgain);
}

}  // namespace mien
