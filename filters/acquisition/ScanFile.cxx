#include "ScanFile.h"

#include <exception>
#include <fstream>
#include <iterator>
#include <vtksys/SystemTools.hxx>

#include "MeshTextFault.h"
#include "RadialSkin.h"
#include "ScanHeader.h"
#include "ScanMesh.h"

namespace mien {

namespace {

bool isKnownFormat(const std::string& ending) {
  return ending == ".ply" || ending == ".obj" || ending == ".stl" || ending == ".off";
}

/// @return nothing, or why a file is not of the format that its ending promises
std::string describeFormat(const std::string& start, const std::string& ending) {
  const auto isText = [&] {
    return start.find('\0') == std::string::npos && start.find("vertex") == std::string::npos;
  };
  if (ending == ".ply" && start.rfind("ply", 0) != 0)
    return "this is no PLY file (it does not begin with \"ply\"); export the scan again, or give the file its right "
           "ending";
  if (ending == ".stl" && (start.size() < 84 || start.rfind("solid", 0) == 0) && isText())
    return "this is no STL file (it is text without a vertex); export the scan again, or give the file its right "
           "ending";
  return {};
}

/// One sentence that says why the beginning of a file cannot be believed, or nothing.
std::string describeHeaderFault(const std::string& file) {
  constexpr std::size_t longestHeader = 1 << 16;
  std::string start(longestHeader, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(stream.gcount()));
  const std::string formatFault = describeFormat(start, endingOf(file));
  if (!formatFault.empty()) return formatFault;
  if (endingOf(file) == ".ply" && start.find("end_header") == std::string::npos)
    return "the header has no end; the file is damaged, export the scan again";  // OpenMesh would search for minutes
  if (promisesTooMuch(start, endingOf(file), vtksys::SystemTools::FileLength(file)))
    return "the header promises more vertices or faces than the file holds, or fewer than none; it is damaged, export "
           "the "
           "scan again";
  return {};
}

/// OpenMesh passes over such faults, and then counts on with other vertices than the file.
std::string describeContent(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  return describeMeshTextFault(text, endingOf(file));
}

bool readThroughOpenMesh(const std::string& file, ScanMesh& scan) {
  const QuietOpenMesh quiet;
  try {
    return OpenMesh::IO::read_mesh(scan, file);
  } catch (const std::exception&) {
    return false;  // sizes in a damaged file can ask for more memory than there is
  }
}

}  // namespace

std::string endingOf(const std::string& file) {
  return vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(file));
}

std::string readScanFile(const std::string& file, TriangleMesh& mesh) {
  if (vtksys::SystemTools::FileIsDirectory(file)) return "it is a folder; give a scan of a head in it";
  if (!vtksys::SystemTools::FileExists(file, true)) return "there is no such file; give a scan of a head";
  if (!isKnownFormat(endingOf(file)))
    return "the ending is none of .ply, .obj, .stl and .off; convert the scan to one of them";
  const std::string headerFault = describeHeaderFault(file);
  if (!headerFault.empty()) return headerFault;
  const std::string contentFault = describeContent(file);
  if (!contentFault.empty()) return contentFault;
  ScanMesh scan;
  if (!readThroughOpenMesh(file, scan))
    return "the file cannot be read as the mesh its ending promises; export the scan again";
  TriangleMesh read = toTriangleMesh(scan);
  const std::string fault = describeFault(read);
  if (fault.empty()) mesh = std::move(read);
  return fault;
}

}  // namespace mien
