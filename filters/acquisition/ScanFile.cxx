#include "ScanFile.h"

#include <fstream>
#include <iterator>
#include <vtksys/SystemTools.hxx>

#include "RadialSkin.h"
#include "ScanHeader.h"
#include "SmallLetters.h"
#include "StlText.h"

namespace mien {

namespace {

bool isKnownFormat(const std::string& ending) {
  return ending == ".ply" || ending == ".obj" || ending == ".stl" || ending == ".off";
}

/// @return nothing, or why a file is not of the format that its ending promises
std::string describeFormat(const std::string& start, const std::string& ending) {
  if (ending == ".ply" && start.rfind("ply", 0) != 0)
    return "this is no PLY file (it does not begin with \"ply\"); export the scan again, or give the file its right "
           "ending";
  const bool isText = start.find('\0') == std::string::npos;
  if (ending == ".stl" && isText && (start.size() < 84 || isTextStl(start)) &&
      inSmallLetters(start).find("vertex") == std::string::npos)
    return "this is no STL file (it is text without a vertex); export the scan again, or give the file its right "
           "ending";
  return {};
}

/// One sentence that says why the beginning of a file cannot be believed, or nothing.
std::string describeHeaderFault(const std::string& text, const std::string& ending) {
  constexpr std::size_t longestHeader = 1 << 16;
  const std::string start = text.substr(0, longestHeader);
  const std::string formatFault = describeFormat(start, ending);
  if (!formatFault.empty()) return formatFault;
  if (ending == ".ply" && start.find("end_header") == std::string::npos)
    return "the header has no end; the file is damaged, export the scan again";
  if (promisesTooMuch(start, ending, text.size()))
    return "the header promises more vertices or faces than the file holds, or fewer than none; it is damaged, export "
           "the scan again";
  return {};
}

std::string describeName(const std::string& file) {
  if (vtksys::SystemTools::FileIsDirectory(file)) return "it is a folder; give a scan of a head in it";
  if (!vtksys::SystemTools::FileExists(file, true)) return "there is no such file; give a scan of a head";
  if (!isKnownFormat(endingOf(file)))
    return "the ending is none of .ply, .obj, .stl and .off; convert the scan to one of them";
  return {};
}

}  // namespace

std::string endingOf(const std::string& file) {
  return vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(file));
}

std::string readScanFile(const std::string& file, MeshText& scan) {
  std::string fault = describeName(file);
  if (!fault.empty()) return file + ": " + fault;
  std::ifstream stream(file, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  fault = describeHeaderFault(text, endingOf(file));
  if (!fault.empty()) return file + ": " + fault;
  MeshText read;
  if (const auto damage = readMeshText(text, endingOf(file), read))
    return file + ":" + (damage->line > 0 ? std::to_string(damage->line) + ": " : " ") + damage->message;
  fault = describeFault(read.mesh);
  if (!fault.empty()) return file + ": " + fault;
  scan = std::move(read);
  return {};
}

}  // namespace mien
