#include "ScanFile.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <vtksys/SystemTools.hxx>

#include "RadialSkin.h"

namespace mien {

namespace {

bool isKnownFormat(const std::string& ending) {
  return ending == ".ply" || ending == ".obj" || ending == ".stl" || ending == ".off";
}

std::string describeName(const std::string& file) {
  if (vtksys::SystemTools::FileIsDirectory(file)) return "it is a folder; give a scan of a head in it";
  if (!vtksys::SystemTools::FileExists(file, true)) return "there is no such file; give a scan of a head";
  if (!isKnownFormat(endingOf(file)))
    return "the ending is none of .ply, .obj, .stl and .off; convert the scan to one of them";
  return {};
}

/// In one go, since scans are large; what is no regular file has no size.
std::string bytesOf(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(file, unknown);
  if (unknown) return std::string(std::istreambuf_iterator<char>(stream), {});
  std::string bytes(static_cast<std::size_t>(size), '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(size));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

}  // namespace

std::string endingOf(const std::string& file) {
  return vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(file));
}

std::string readScanFile(const std::string& file, MeshText& scan) {
  std::string fault = describeName(file);
  if (!fault.empty()) return file + ": " + fault;
  const std::string text = bytesOf(file);
  MeshText read;
  if (const auto damage = readMeshText(text, endingOf(file), read))
    return file + ":" + (damage->line > 0 ? std::to_string(damage->line) + ": " : " ") + damage->message;
  fault = describeFault(read.mesh);
  if (!fault.empty()) return file + ": " + fault;
  scan = std::move(read);
  return {};
}

}  // namespace mien
