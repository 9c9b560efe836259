#include "ScanFile.h"

#include "RadialSkin.h"

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/DefaultTriMesh.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>

#include <vtksys/SystemTools.hxx>

#include <exception>

namespace mien
{

namespace
{

using ScanMesh = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;

/// OpenMesh reports on the console; the one sentence this file returns is enough.
class QuietOpenMesh
{
public:
  QuietOpenMesh()
  {
    omerr().disable();
    omlog().disable();
  }
  ~QuietOpenMesh()
  {
    omerr().enable();
    omlog().enable();
  }
};

bool isKnownFormat(const std::string& file)
{
  const std::string ending = vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(file));
  return ending == ".ply" || ending == ".obj" || ending == ".stl" || ending == ".off";
}

TriangleMesh toTriangleMesh(const ScanMesh& scan)
{
  TriangleMesh mesh;
  mesh.vertices.resize(static_cast<int>(scan.n_vertices()), 3);
  mesh.triangles.resize(static_cast<int>(scan.n_faces()), 3);
  for (const auto vertex : scan.vertices())
    mesh.vertices.row(vertex.idx()) = Eigen::Map<const Eigen::RowVector3d>(scan.point(vertex).data());
  for (const auto face : scan.faces())
  {
    int corner = 0;
    for (const auto vertex : face.vertices())
      mesh.triangles(face.idx(), corner++) = vertex.idx();
  }
  return mesh;
}

bool readThroughOpenMesh(const std::string& file, ScanMesh& scan)
{
  const QuietOpenMesh quiet;
  try
  {
    return OpenMesh::IO::read_mesh(scan, file);
  }
  catch (const std::exception&)
  {
    return false; // sizes in a damaged header can ask for more memory than there is
  }
}

} // namespace

std::string readScanFile(const std::string& file, TriangleMesh& mesh)
{
  if (!vtksys::SystemTools::FileExists(file, true))
    return "there is no such file; give a scan of a head";
  if (!isKnownFormat(file))
    return "the ending is none of .ply, .obj, .stl and .off; convert the scan to one of them";
  ScanMesh scan;
  if (!readThroughOpenMesh(file, scan))
    return "the file cannot be read as the mesh its ending promises; export the scan again";
  TriangleMesh read = toTriangleMesh(scan);
  const std::string fault = describeFault(read);
  if (fault.empty())
    mesh = std::move(read);
  return fault;
}

} // namespace mien
