#include "OutwardMesh.h"

#include <Eigen/Geometry>

#include "Failure.h"
#include "MeshFile.h"
#include "SurfaceFile.h"
#include "vtkCellArray.h"
#include "vtkIdList.h"
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

/// Six times the volume between the polygons and the middle of their points: negative where they are wound inwards. An
/// opening, as at the neck, takes little of it.
double signedVolume(vtkPolyData* mesh) {
  const Eigen::Vector3d middle = Eigen::Map<const Eigen::Vector3d>(mesh->GetCenter());
  const auto point = [&](vtkIdType i) {
    Eigen::Vector3d p;
    mesh->GetPoint(i, p.data());
    return Eigen::Vector3d(p - middle);
  };
  double volume = 0.0;
  vtkNew<vtkIdList> corners;
  for (mesh->GetPolys()->InitTraversal(); mesh->GetPolys()->GetNextCell(corners);)
    for (vtkIdType k = 2; k < corners->GetNumberOfIds(); ++k)
      volume += point(corners->GetId(0)).dot(point(corners->GetId(k - 1)).cross(point(corners->GetId(k))));
  return volume;
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
  if (signedVolume(mesh) >= 0.0) return source;
  const auto reversed = vtkSmartPointer<vtkReverseSense>::New();
  reversed->SetInputConnection(source->GetOutputPort());
  reversed->ReverseNormalsOn();
  return reversed;
}

}  // namespace mien
