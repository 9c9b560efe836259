#pragma once

#include <OpenMesh/Core/Mesh/DefaultTriMesh.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>

#include "TriangleMesh.h"

namespace mien {

/// Triangles with double coordinates, as OpenMesh holds them.
using ScanMesh = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;

/// OpenMesh reports on the console; the one sentence our functions return is enough.
class QuietOpenMesh {
 public:
  QuietOpenMesh();
  ~QuietOpenMesh();
  QuietOpenMesh(const QuietOpenMesh&) = delete;
  QuietOpenMesh& operator=(const QuietOpenMesh&) = delete;
};

/// The scan's vertices and triangles, in their order.
TriangleMesh toTriangleMesh(const ScanMesh& scan);

/// Triangles that no surface can have, such as a third one at an edge, are left out.
ScanMesh toScanMesh(const TriangleMesh& mesh);

}  // namespace mien
