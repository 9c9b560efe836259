#include "ScanFile.h"

#include <exception>
#include <fstream>
#include <vtksys/SystemTools.hxx>

#include "RadialSkin.h"
#include "ScanHeader.h"
#include "ScanMesh.h"

namespace mien {

namespace {

std::string endingOf(const std::string& file) {
  return vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(file));
}

bool isKnownFormat(const std::string& ending) {
  return ending == ".ply" || ending == ".obj" || ending == ".stl" || ending == ".off";
}

/// One sentence that says why the beginning of a file cannot be believed, or nothing.
std::string describeHeaderFault(const std::string& file) {
  constexpr std::size_t longestHeader = 1 << 16;
  std::string start(longestHeader, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(stream.gcount()));
  if (endingOf(file) == ".ply" && start.find("end_header") == std::string::npos)
    return "the header has no end; the file is damaged, export the scan again";  // OpenMesh would search for minutes
  if (promisesTooMuch(start, endingOf(file), vtksys::SystemTools::FileLength(file)))
    return "the header promises more vertices or faces than the file holds, or fewer than none; it is damaged, export "
           "the "
           "scan again";
  return {};
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

std::string readScanFile(const std::string& file, TriangleMesh& mesh) {
  if (!vtksys::SystemTools::FileExists(file, true)) return "there is no such file; give a scan of a head";
  if (!isKnownFormat(endingOf(file)))
    return "the ending is none of .ply, .obj, .stl and .off; convert the scan to one of them";
  const std::string headerFault = describeHeaderFault(file);
  if (!headerFault.empty()) return headerFault;
  ScanMesh scan;
  if (!readThroughOpenMesh(file, scan))
    return "the file cannot be read as the mesh its ending promises; export the scan again";
  TriangleMesh read = toTriangleMesh(scan);
  const std::string fault = describeFault(read);
  if (fault.empty()) mesh = std::move(read);
  return fault;
}

}  // namespace mien
