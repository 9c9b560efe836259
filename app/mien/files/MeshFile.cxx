#include "MeshFile.h"

#include "Failure.h"
#include "MeshReading.h"
#include "vtkDataObject.h"

namespace mien {

vtkSmartPointer<vtkDataObject> readMesh(const std::string& name) {
  if (!isSurfaceFile(name))
    throw ValueFailure("surface '" + name +
                       "' has an unknown ending; the known ones are .vts .vtp .ply .obj .stl .off");
  vtkSmartPointer<vtkDataObject> surface;
  const std::string fault = readSurfaceFile(name, surface);
  if (!fault.empty()) throw FileFailure(fault);
  return surface;
}

}  // namespace mien
