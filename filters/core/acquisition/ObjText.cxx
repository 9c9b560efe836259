#include "ObjText.h"

#include <vector>

#include "LineCutter.h"
#include "MeshBuilder.h"
#include "NumberText.h"
#include "VertexWords.h"

namespace mien {

namespace {

/// The words of an .obj file's lines, those that go on behind a backslash joined.
class ObjLines {
 public:
  explicit ObjLines(std::string_view text) : lines_(text) {}

  bool next() {
    words.clear();
    for (std::string_view line; lines_.next(line);) {
      if (words.empty()) number = lines_.number();
      const bool goesOn = !line.empty() && line.back() == '\\';
      if (goesOn) line.remove_suffix(1);
      splitAtBlanks(line, parts_);
      words.insert(words.end(), parts_.begin(), parts_.end());
      if (!goesOn && !words.empty()) return true;
    }
    return !words.empty();
  }

  std::vector<std::string_view> words;
  std::int64_t number = 0;

 private:
  LineCutter lines_;
  std::vector<std::string_view> parts_;
};

class ObjFaces {
 public:
  explicit ObjFaces(MeshBuilder& mesh) : mesh_(mesh) {}

  void noteVertex() { ++soFar_; }

  /// @return nothing, or what is wrong
  std::string read(const ObjLines& line) {
    corners_.clear();
    for (std::size_t i = 1; i < line.words.size() && line.words[i].front() != '#'; ++i) {
      const auto corner = parseWholeNumber(line.words[i].substr(0, line.words[i].find('/')));
      if (!corner) return "a face has " + inQuotes(line.words[i]) + " where the number of a vertex belongs";
      const bool exists = *corner >= 1 ? *corner <= mesh_.vertexCount() : *corner < 0 && *corner >= -soFar_;
      if (!exists) {
        mesh_.noteLost(*corner, line.number);
        return {};
      }
      corners_.push_back(*corner > 0 ? *corner - 1 : soFar_ + *corner);
    }
    mesh_.addPolygon(corners_, line.number);
    return {};
  }

 private:
  MeshBuilder& mesh_;
  std::vector<std::int64_t> corners_;
  std::int64_t soFar_ = 0;
};

}  // namespace

std::optional<MeshFault> readObjText(std::string_view text, MeshText& read) {
  MeshBuilder mesh;
  for (ObjLines line(text); line.next();) {
    if (line.words[0] != "v") continue;
    double place[3];
    const std::string fault = readVertexWords(line.words, place);
    if (!fault.empty()) return MeshFault{line.number, fault + exportMeshAgain};
    mesh.addVertex(place);
  }
  ObjFaces faces(mesh);
  for (ObjLines line(text); line.next();) {
    if (line.words[0] == "v") faces.noteVertex();
    if (line.words[0] != "f") continue;
    const std::string fault = faces.read(line);
    if (!fault.empty()) return MeshFault{line.number, fault + exportMeshAgain};
  }
  return mesh.finish(read);
}

}  // namespace mien
