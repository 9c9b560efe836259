#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

/// Walks through the vertices and faces of a .ply or .off file (text or binary), one after the other, without
/// building a mesh. The text must outlive it. What cannot be followed ends the walk. Lines end in LF, CR LF or CR.
class PolygonFile {
 public:
  /// Whether a text begins with "ply", behind a byte order mark and blanks.
  static bool isPly(std::string_view text);

  bool openPly(std::string_view text);
  bool openOff(std::string_view text);

  std::int64_t vertexCount() const { return vertices_; }
  std::int64_t faceCount() const { return faces_; }  ///< or of strips
  bool hasStrips() const { return facesAre_ == "tristrips"; }

  /// All vertices must be read before the first face, whatever their order in the file.
  bool readVertex(double (&place)[3]);

  /// Corners of the next face, or strip of triangles; -1 then begins another.
  bool readFace(std::vector<std::int64_t>& corners);

  /// Why the file could not be opened, or went no further: "has 'x' where a number belongs".
  const std::string& fault() const { return fault_; }

  /// Where it went no further, from 1; 0 in a binary file, behind its header.
  std::int64_t lineHere() const { return inHeader_ || encoding_ == Encoding::Text ? line_ : 0; }

  /// Where the vertex or face that was read last begins; 0 in a binary file.
  std::int64_t lineOfRow() const { return encoding_ == Encoding::Text ? rowLine_ : 0; }

  /// The last word of a text that was given as a place but is no finite number.
  std::string_view infinitePlace() const { return infinitePlace_; }

 private:
  enum class Encoding { Text, LittleEndian, BigEndian };
  struct Type {
    int bytes = 0;  ///< 0: unknown
    bool isSigned = false, isReal = false;
  };
  struct Property {
    std::string name;
    Type type, countType;
    bool isList = false;
  };
  struct Element {
    std::string name;
    std::int64_t count = 0;
    std::vector<Property> properties;
    std::int64_t line = 1;
  };

  static Type typeOf(std::string_view name);
  void begin(std::string_view text);
  bool refuse(const std::string& why);
  bool refuseElement(const std::string& name, const std::string& why);
  bool readHeader();
  std::string_view cutHeaderLine(char end);
  bool readProperty(const std::vector<std::string_view>& words);
  bool findElements();
  bool findFaces();
  const Element* element(const std::string& name) const;
  bool skipCommentsAndBlanks();
  bool endsLine() const;
  std::size_t lineEnd() const;
  bool openOffText(bool hasMore);
  bool openOffBytes(int moreWords, bool hasColours);
  bool hasLinePerRow(std::int64_t rows) const;
  bool readHeaderLine(const std::vector<std::string_view>& words);
  bool skipTo(std::size_t wanted);
  bool readRow(const Element& element, double (*place)[3], std::vector<std::int64_t>* corners);
  bool readList(const Property& property, std::vector<std::int64_t>* corners);
  bool next(const Type& type, double& value);
  bool nextWord(double& value);
  bool skipWord();
  double binaryValue(const Type& type) const;

  std::string_view text_;
  std::size_t at_ = 0;
  std::int64_t line_ = 1, rowLine_ = 1, vertices_ = 0, faces_ = 0, rowsRead_ = 0;
  std::size_t bodyAt_ = 0;
  std::int64_t bodyLine_ = 1;
  std::string facesAre_ = "face", fault_;
  std::string_view infiniteWord_, infinitePlace_;
  bool inHeader_ = true;
  Encoding encoding_ = Encoding::Text;
  bool skipsRestOfVertex_ = false, skipsRestOfFace_ = false;  ///< more stands in the line that is passed over
  std::vector<Element> elements_;
  std::size_t element_ = 0, verticesAt_ = 0, facesAt_ = 0;
};

}  // namespace mien
