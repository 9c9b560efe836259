#include "MeshSeries.h"

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include "ScanMesh.h"

namespace mien {

bool decimateInSteps(const TriangleMesh& mesh, const std::vector<int>& triangles,
                     const std::function<bool(const TriangleMesh&)>& take) {
  const QuietOpenMesh quiet;
  ScanMesh scan = toScanMesh(mesh);
  OpenMesh::Decimater::DecimaterT<ScanMesh> decimater(scan);
  OpenMesh::Decimater::ModQuadricT<ScanMesh>::Handle quadric;
  decimater.add(quadric);
  decimater.initialize();
  for (const int count : triangles) {
    decimater.decimate_to_faces(0, static_cast<size_t>(count));
    scan.garbage_collection();  // else the next step counts what is deleted as well; quadrics move along
    if (!take(toTriangleMesh(scan))) return false;
  }
  return true;
}

}  // namespace mien
