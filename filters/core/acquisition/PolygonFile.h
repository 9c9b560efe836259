#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

/// Walks through the vertices and faces of a .ply or .off file (text or binary), one after the other, without
/// building a mesh. The text must outlive it. What cannot be followed ends the walk.
class PolygonFile {
 public:
  bool openPly(std::string_view text);
  bool openOff(std::string_view text);

  std::int64_t vertexCount() const { return vertices_; }
  std::int64_t faceCount() const { return faces_; }

  /// All vertices must be read before the first face.
  bool readVertex(double (&place)[3]);
  bool readFace(std::vector<std::int64_t>& corners);

  /// "line 12" of what was read last, "vertex 7" in a binary file.
  std::string place(const std::string& what, std::int64_t number) const;

  /// "line 12: " of what could not be read, nothing in a binary file.
  std::string lineHere() const;

 private:
  enum class Encoding { Text, LittleEndian, BigEndian };
  struct Type {
    int bytes = 0;
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
  };

  static Type typeOf(std::string_view name);
  bool readHeader();
  bool readHeaderLine(const std::vector<std::string_view>& words);
  bool skipTo(const char* element);
  bool readRow(const Element& element, double (*place)[3], std::vector<std::int64_t>* corners);
  bool readList(const Property& property, std::vector<std::int64_t>* corners);
  bool next(const Type& type, double& value);
  bool nextWord(double& value);
  double binaryValue(const Type& type) const;

  std::string_view text_;
  std::size_t at_ = 0;
  std::int64_t line_ = 1, rowLine_ = 1, vertices_ = 0, faces_ = 0, rowsRead_ = 0;
  Encoding encoding_ = Encoding::Text;
  bool restOfLine_ = false;  ///< behind the place of a vertex stands more that is passed over
  std::vector<Element> elements_;
  std::size_t element_ = 0;
};

}  // namespace mien
