#include "ScanMesh.h"

#include <vector>

namespace mien {

QuietOpenMesh::QuietOpenMesh() {
  omerr().disable();
  omlog().disable();
}

QuietOpenMesh::~QuietOpenMesh() {
  omerr().enable();
  omlog().enable();
}

TriangleMesh toTriangleMesh(const ScanMesh& scan) {
  TriangleMesh mesh;
  mesh.vertices.resize(static_cast<int>(scan.n_vertices()), 3);
  mesh.triangles.resize(static_cast<int>(scan.n_faces()), 3);
  for (const auto vertex : scan.vertices())
    mesh.vertices.row(vertex.idx()) = Eigen::Map<const Eigen::RowVector3d>(scan.point(vertex).data());
  for (const auto face : scan.faces()) {
    int corner = 0;
    for (const auto vertex : face.vertices()) mesh.triangles(face.idx(), corner++) = vertex.idx();
  }
  return mesh;
}

ScanMesh toScanMesh(const TriangleMesh& mesh) {
  ScanMesh scan;
  scan.reserve(static_cast<size_t>(mesh.vertices.rows()), static_cast<size_t>(3 * mesh.vertices.rows()),
               static_cast<size_t>(mesh.triangles.rows()));
  std::vector<ScanMesh::VertexHandle> handles;
  for (int i = 0; i < mesh.vertices.rows(); ++i)
    handles.push_back(scan.add_vertex({mesh.vertices(i, 0), mesh.vertices(i, 1), mesh.vertices(i, 2)}));
  for (int t = 0; t < mesh.triangles.rows(); ++t)
    scan.add_face(handles[mesh.triangles(t, 0)], handles[mesh.triangles(t, 1)], handles[mesh.triangles(t, 2)]);
  return scan;
}

}  // namespace mien
