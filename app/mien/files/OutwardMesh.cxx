#include "OutwardMesh.h"

#include "Failure.h"
#include "MeshCleaning.h"
#include "MeshData.h"
#include "MeshFile.h"
#include "SurfaceFile.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkReverseSense.h"
#include "vtkStructuredGrid.h"
#include "vtkTrivialProducer.h"

namespace mien {

namespace {

vtkSmartPointer<vtkPolyData> polygonsOf(vtkDataObject* data) {
  if (auto* grid = vtkStructuredGrid::SafeDownCast(data)) return outwardPolygons(grid, false);
  return vtkPolyData::SafeDownCast(data);
}

bool isWoundInwards(vtkPolyData* mesh, const std::string& file) {
  if (mesh->GetNumberOfPolys() == 0) return false;  // strips are drawn as they are
  TriangleMesh triangles;
  const std::string fault = readTriangleMesh(mesh, triangles);
  if (!fault.empty()) throw FileFailure(file + ": " + fault);
  return signedVolume(triangles) < 0.0;
}

}  // namespace

vtkSmartPointer<vtkAlgorithm> outwardMesh(const std::string& file) {
  const auto mesh = polygonsOf(readMesh(file));
  if (!mesh || mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() == 0)
    throw FileFailure(file + ": there are no polygons to draw; boundary curves are drawn as a face with --face " +
                      file);
  vtkSmartPointer<vtkAlgorithm> source = vtkSmartPointer<vtkTrivialProducer>::New();
  vtkTrivialProducer::SafeDownCast(source)->SetOutput(mesh);
  if (!mesh->GetPointData()->GetNormals()) {
    const auto normals = vtkSmartPointer<vtkPolyDataNormals>::New();
    normals->SetInputConnection(source->GetOutputPort());
    normals->SplittingOff();
    normals->ConsistencyOff();
    source = normals;
  }
  if (!isWoundInwards(mesh, file)) return source;
  const auto reversed = vtkSmartPointer<vtkReverseSense>::New();
  reversed->SetInputConnection(source->GetOutputPort());
  reversed->ReverseNormalsOn();
  return reversed;
}

}  // namespace mien
