#include "ScanHeader.h"

#include <cstring>
#include <locale>
#include <sstream>

#include "StlText.h"

namespace mien {

namespace {

std::istringstream classicStream(const std::string& text) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  return stream;
}

/// A negative count would wrap into a large one; one that is no number is left for the reader to refuse.
bool isUnsound(std::istream& stream, std::uintmax_t size) {
  double count = 0.0;
  stream >> count;
  return count < 0.0 || count > static_cast<double>(size);
}

/// Lines such as "element vertex 14388".
bool plyPromisesTooMuch(const std::string& start, std::uintmax_t size) {
  std::istringstream lines = classicStream(start);
  for (std::string line; std::getline(lines, line) && line.rfind("end_header", 0) != 0;) {
    std::istringstream words = classicStream(line);
    std::string keyword, name;
    words >> keyword;
    if (keyword == "element" && words >> name && isUnsound(words, size)) return true;
  }
  return false;
}

std::uint32_t littleEndianWord(const std::string& bytes, std::size_t at) {
  unsigned char b[4] = {};
  if (bytes.size() >= at + 4) std::memcpy(b, bytes.data() + at, 4);
  return b[0] | b[1] << 8 | b[2] << 16 | static_cast<std::uint32_t>(b[3]) << 24;
}

/// "OFF", then the numbers of vertices and faces: as text on this or a later line, or as two binary words.
bool offPromisesTooMuch(const std::string& start, std::uintmax_t size) {
  const std::size_t lineEnd = start.find('\n');
  const std::string first = start.substr(0, lineEnd);
  if (first.find("BINARY") != std::string::npos && lineEnd != std::string::npos)
    return littleEndianWord(start, lineEnd + 1) > size || littleEndianWord(start, lineEnd + 5) > size;
  std::istringstream lines = classicStream(start);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t number = line.find_first_of("-0123456789");
    if (line.rfind('#', 0) == 0 || number == std::string::npos) continue;
    std::istringstream counts = classicStream(line.substr(number));
    return isUnsound(counts, size) || isUnsound(counts, size);
  }
  return false;
}

/// Binary files: 80 bytes of title, the number of triangles, 50 bytes for each.
bool stlPromisesTooMuch(const std::string& start, std::uintmax_t size) {
  constexpr std::uintmax_t headerBytes = 84, triangleBytes = 50;
  return !isTextStl(start) && headerBytes + triangleBytes * littleEndianWord(start, headerBytes - 4) > size;
}

}  // namespace

bool promisesTooMuch(const std::string& start, const std::string& ending, std::uintmax_t size) {
  if (ending == ".ply") return plyPromisesTooMuch(start, size);
  if (ending == ".off") return offPromisesTooMuch(start, size);
  return ending == ".stl" && stlPromisesTooMuch(start, size);
}

}  // namespace mien
