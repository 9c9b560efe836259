#include "FaceTexture.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "FaceWarpLayout.h"
#include "ImageFile.h"
#include "PipelineErrors.h"
#include "WarpMeshData.h"
#include "vtkDataArray.h"
#include "vtkFaceWarpMeshFilter.h"
#include "vtkImageData.h"
#include "vtkImageMeshWarpFilter.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWarpMeshReader.h"

namespace mien {

namespace {

/// Grey becomes red, green and blue, and any range 0 .. 255: renderers would else take colours from a table.
void makeColours(vtkImageData* image) {
  vtkDataArray* from = image->GetPointData()->GetScalars();
  const int components = from->GetNumberOfComponents(), colours = components == 2 || components >= 4 ? 4 : 3;
  const bool floating = from->GetDataType() == VTK_FLOAT || from->GetDataType() == VTK_DOUBLE;
  const double scale = 255.0 / (floating ? 1.0 : from->GetDataTypeMax());
  vtkNew<vtkUnsignedCharArray> to;
  to->SetNumberOfComponents(colours);
  to->SetNumberOfTuples(from->GetNumberOfTuples());
  for (vtkIdType i = 0; i < from->GetNumberOfTuples(); ++i)
    for (int c = 0; c < colours; ++c) {
      const int component = components >= 3 ? c : (c == 3 ? 1 : 0);
      const double value = scale * from->GetComponent(i, component);
      to->SetTypedComponent(
          i, c, static_cast<unsigned char>(std::clamp(std::isfinite(value) ? value : 0.0, 0.0, 255.0) + 0.5));
    }
  image->GetPointData()->SetScalars(to);
}

std::string readMesh(vtkWarpMeshReader* reader, const std::string& file, FaceWarpLayout::Kind& kind) {
  PipelineErrors errors;
  errors.observe(reader);
  reader->SetFileName(file.c_str());
  reader->Update();
  if (!errors.first().empty()) return errors.first();
  WarpMesh mesh;
  const std::string fault = readWarpMesh(reader->GetOutput(), mesh);
  if (!fault.empty() || FaceWarpLayout::kindOf(mesh, kind)) return fault;
  return file + ": a mesh of " + std::to_string(mesh.rows()) + " x " + std::to_string(mesh.columns()) +
         " points has no places on the face; give one of 7 x 7, or one made by mien texture";
}

}  // namespace

std::string meshBeside(const std::string& imageFile) {
  return std::filesystem::path(imageFile).replace_extension(".csv").string();
}

std::string makeFaceTexture(const FaceState& state, vtkPolyData* curves, vtkImageData* texture) {
  vtkNew<vtkImageData> photograph;
  vtkNew<vtkWarpMeshReader> source;
  FaceWarpLayout::Kind kind{};
  const std::string meshFile = state.textureMesh.empty() ? meshBeside(state.texture) : state.textureMesh;
  std::string fault = readImageFile(state.texture, photograph);
  if (fault.empty()) fault = readMesh(source, meshFile, kind);
  if (!fault.empty()) return fault;
  vtkNew<vtkFaceWarpMeshFilter> target;
  target->SetInputDataObject(curves);
  target->SetFine(kind == FaceWarpLayout::Kind::Fine);
  vtkNew<vtkImageMeshWarpFilter> warp;
  warp->SetInputData(photograph);
  warp->SetSourceMeshConnection(source->GetOutputPort());
  warp->SetTargetMeshConnection(target->GetOutputPort());
  warp->SetOutputSize(target->GetTextureSize()[0], target->GetTextureSize()[1]);
  warp->ClosedOn();
  PipelineErrors errors;
  errors.observe(target);
  errors.observe(warp);
  warp->Update();
  if (!errors.first().empty()) return meshFile + ": " + errors.first();
  texture->ShallowCopy(warp->GetOutput());
  makeColours(texture);
  return {};
}

}  // namespace mien
