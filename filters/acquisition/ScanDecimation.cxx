#include "ScanDecimation.h"

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include "ScanMesh.h"

namespace mien {

void decimate(TriangleMesh& mesh, int triangles) {
  if (mesh.triangles.rows() <= triangles) return;
  const QuietOpenMesh quiet;
  ScanMesh scan = toScanMesh(mesh);
  OpenMesh::Decimater::DecimaterT<ScanMesh> decimater(scan);
  OpenMesh::Decimater::ModQuadricT<ScanMesh>::Handle quadric;
  decimater.add(quadric);
  decimater.initialize();
  decimater.decimate_to_faces(0, static_cast<size_t>(triangles));
  scan.garbage_collection();
  mesh = toTriangleMesh(scan);
}

}  // namespace mien
