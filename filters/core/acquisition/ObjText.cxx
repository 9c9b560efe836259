#include "ObjText.h"

#include <algorithm>
#include <vector>

#include "LineCutter.h"
#include "MeshBuilder.h"
#include "NumberText.h"
#include "VertexWords.h"

namespace mien {

namespace {

/// The lines of an .obj file, cut word by word, since a line may be as long as the file. Vertices and faces go on
/// behind a backslash and end at '#'; the names and comments of other lines may hold either.
class ObjLines {
 public:
  explicit ObjLines(std::string_view text) : lines_(text) {}

  /// The next line with a word, whatever is left of the last one.
  bool next() {
    for (std::string_view skipped; goesOn_;) nextWord(skipped);
    while (lines_.next(rest_)) {
      number = lines_.number();
      if (!cutWord(keyword)) continue;
      const bool isGeometry = keyword == "v" || keyword == "vt" || keyword == "vn" || keyword == "f";
      if (isGeometry)
        endLine();
      else
        rest_ = {};
      return true;
    }
    return false;
  }

  /// The next word behind the keyword of a vertex or face.
  bool nextWord(std::string_view& word) {
    while (!cutWord(word)) {
      if (!goesOn_) return false;
      goesOn_ = false;
      if (lines_.next(rest_)) endLine();
    }
    return true;
  }

  std::string_view keyword;
  std::int64_t number = 0;

 private:
  static bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

  bool cutWord(std::string_view& word) {
    const auto begin = std::find_if_not(rest_.begin(), rest_.end(), isBlank);
    const auto end = std::find_if(begin, rest_.end(), isBlank);
    word = rest_.substr(begin - rest_.begin(), end - begin);
    rest_.remove_prefix(end - rest_.begin());
    return !word.empty();
  }

  void endLine() {
    rest_ = rest_.substr(0, rest_.find('#'));
    goesOn_ = !rest_.empty() && rest_.back() == '\\';
    if (goesOn_) rest_.remove_suffix(1);
  }

  LineCutter lines_;
  std::string_view rest_;
  bool goesOn_ = false;
};

/// @return nothing, or what is wrong
std::string readVertex(ObjLines& line, std::vector<std::string_view>& words, MeshBuilder& mesh) {
  words = {line.keyword};
  for (std::string_view word; words.size() <= 3 && line.nextWord(word);) words.push_back(word);
  double place[3];
  const std::string fault = readVertexWords(words, place);
  if (fault.empty()) mesh.addVertex(place);
  return fault;
}

class ObjFaces {
 public:
  explicit ObjFaces(MeshBuilder& mesh) : mesh_(mesh) {}

  void noteVertex() { ++soFar_; }

  /// Splits a face around its first corner while its corners are cut, since it may have as many as the file has words.
  /// @return nothing, or what is wrong
  std::string read(ObjLines& line) {
    std::int64_t first = 0, last = 0;
    std::size_t corners = 0;
    for (std::string_view word; line.nextWord(word); ++corners) {
      const auto number = parseWholeNumber(word.substr(0, word.find('/')));
      if (!number) return "a face has " + inQuotes(word) + " where the number of a vertex belongs";
      const bool exists = *number >= 1 ? *number <= mesh_.vertexCount() : *number < 0 && *number >= -soFar_;
      if (!exists) {
        mesh_.noteLost(*number, line.number);
        return {};
      }
      const std::int64_t corner = *number > 0 ? *number - 1 : soFar_ + *number;
      if (corners == 0) first = corner;
      if (corners >= 2) mesh_.addTriangle(first, last, corner);
      last = corner;
    }
    mesh_.count(corners);
    return {};
  }

 private:
  MeshBuilder& mesh_;
  std::int64_t soFar_ = 0;
};

}  // namespace

std::optional<MeshFault> readObjText(std::string_view text, MeshText& read) {
  MeshBuilder mesh;
  std::vector<std::string_view> words;
  for (ObjLines line(text); line.next();) {
    if (line.keyword != "v") continue;
    const std::string fault = readVertex(line, words, mesh);
    if (!fault.empty()) return MeshFault{line.number, fault + exportMeshAgain};
  }
  ObjFaces faces(mesh);
  for (ObjLines line(text); line.next();) {
    if (line.keyword == "v") faces.noteVertex();
    if (line.keyword != "f") continue;
    const std::string fault = faces.read(line);
    if (!fault.empty()) return MeshFault{line.number, fault + exportMeshAgain};
  }
  return mesh.finish(read);
}

}  // namespace mien
