#include "CompactFaceFile.h"

#include <vtksys/FStream.hxx>
#include <vtksys/SystemTools.hxx>

namespace mien {

namespace {

/// At most `limit` bytes from the start of a file.
std::string startOf(const std::string& name, std::size_t limit) {
  vtksys::ifstream file(name.c_str(), std::ios::binary);
  std::string bytes(limit, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(limit));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

}  // namespace

bool isCompactFaceFile(const std::string& name) {
  constexpr std::size_t enough = 8;
  return vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(name)) == ".mienz" ||
         isCompactFace(startOf(name, enough));
}

std::string readCompactFaceFile(const std::string& name, CompactFace& compact) {
  if (!vtksys::SystemTools::FileExists(name, true)) return name + ": there is no such file; give a compact face file";
  const unsigned long size = vtksys::SystemTools::FileLength(name);
  if (size > CompactFaceLimits::largestFile)
    return name + ": the file is larger than any compact face (" + std::to_string(CompactFaceLimits::largestFile) +
           " bytes); is it something else?";
  const std::string fault = decodeCompactFace(startOf(name, size), compact);
  return fault.empty() ? fault : name + ": " + fault;
}

}  // namespace mien
