#include "FaceTexture.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "BoundaryCurveData.h"
#include "FilterProgress.h"
#include "ImageFile.h"
#include "InlineText.h"
#include "PipelineErrors.h"
#include "TextFileReader.h"
#include "WarpMeshData.h"
#include "WarpMeshText.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkImageMeshWarpFilter.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

namespace mien {

namespace {

// The largest warp mesh has 65,536 points and about 4 MB; a file larger than this is something else.
constexpr std::size_t largestPlacesText = 10'000'000;

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

/// @return nothing, or what went wrong
std::string runWarp(vtkImageMeshWarpFilter* warp, const Progress& progress) {
  PipelineErrors errors;
  errors.observe(warp);
  const bool complete = updateWith(progress, warp);
  if (!errors.first().empty()) return errors.first();
  return complete ? "" : "the work was stopped";
}

/// For messages.
std::string nameOfMesh(const std::string& fileOrText) {
  return isInlineText(fileOrText) ? "mesh" : fileOrText;
}

std::string layoutOn(vtkPolyData* curves, FaceWarpLayout::Kind kind, FaceCurves& face, FaceWarpLayout& layout) {
  const std::string fault = readFaceCurves(curves, face);
  return fault.empty() ? layout.set(kind, face) : fault;
}

}  // namespace

std::string meshBeside(const std::string& imageFile) {
  return std::filesystem::path(imageFile).replace_extension(".csv").string();
}

std::string readSourceMesh(const std::string& fileOrText, WarpMesh& mesh) {
  const bool isText = isInlineText(fileOrText);
  std::string text, fault;
  if (!isText) fault = readTextFile(fileOrText, largestPlacesText, text, "warp mesh");
  WarpMesh read;
  if (fault.empty()) fault = parseWarpMesh(isText ? fileOrText : text, read);
  if (!fault.empty()) return nameOfMesh(fileOrText) + ":" + fault;
  FaceWarpLayout::Kind kind{};
  if (!FaceWarpLayout::kindOf(read, kind))
    return nameOfMesh(fileOrText) + ": a mesh of " + std::to_string(read.rows()) + " x " +
           std::to_string(read.columns()) +
           " points has no places on the face; give one of 7 x 7, or one made by mien texture";
  mesh = std::move(read);
  return {};
}

std::string readLandmarkMesh(const std::string& file, FaceWarpLayout::Kind kind, vtkPolyData* curves, double width,
                             double height, WarpMesh& mesh) {
  std::string text;
  std::string fault = readTextFile(file, largestPlacesText, text, "list of landmarks");
  if (!fault.empty()) return file + ":" + fault;
  ImageLandmarks landmarks;
  fault = parseImageLandmarks(text, landmarks);
  if (!fault.empty()) return file + ":" + fault;
  FaceCurves face;
  FaceWarpLayout layout;
  fault = layoutOn(curves, kind, face, layout);
  if (fault.empty()) fault = photographMesh(layout, face, landmarks, width, height, mesh);
  return fault.empty() ? fault : file + ": " + fault;
}

std::string makeStartingMesh(vtkPolyData* curves, double width, double height, WarpMesh& mesh) {
  FaceCurves face;
  FaceWarpLayout layout;
  const std::string fault = layoutOn(curves, FaceWarpLayout::Kind::SevenBySeven, face, layout);
  if (fault.empty()) mesh = startingMesh(layout, face, width, height);
  return fault;
}

std::string warpFaceTexture(vtkImageData* photograph, const WarpMesh& source, vtkPolyData* curves, int width,
                            int height, const Progress& progress, vtkImageData* texture) {
  FaceWarpLayout::Kind kind{};
  if (!FaceWarpLayout::kindOf(source, kind)) return "the mesh has no places on the face; give one of 7 x 7 points";
  FaceCurves face;
  FaceWarpLayout layout;
  std::string fault = layoutOn(curves, kind, face, layout);
  if (!fault.empty()) return fault;
  vtkNew<vtkStructuredGrid> from, to;
  writeWarpMesh(source, from);
  writeWarpMesh(textureMesh(layout, width, height), to);
  vtkNew<vtkImageMeshWarpFilter> warp;
  warp->SetInputData(photograph);
  warp->SetSourceMeshData(from);
  warp->SetTargetMeshData(to);
  warp->SetOutputSize(width, height);
  warp->ClosedOn();
  fault = runWarp(warp, progress);
  if (!fault.empty()) return fault;
  texture->ShallowCopy(warp->GetOutput());
  makeColours(texture);
  return {};
}

std::string makeFaceTexture(const FaceState& state, vtkPolyData* curves, vtkImageData* texture) {
  vtkNew<vtkImageData> photograph;
  const std::string mesh = state.textureMesh.empty() ? meshBeside(state.texture) : state.textureMesh;
  WarpMesh source;
  std::string fault = readImageFile(state.texture, photograph);
  if (fault.empty()) fault = readSourceMesh(mesh, source);
  if (!fault.empty()) return fault;
  FaceCurves face;
  fault = readFaceCurves(curves, face);
  if (!fault.empty()) return (state.curvesFile.empty() ? "the generic face" : state.curvesFile) + ": " + fault;
  fault = warpFaceTexture(photograph, source, curves, faceTextureWidth, faceTextureHeight, {}, texture);
  return fault.empty() ? fault : nameOfMesh(mesh) + ": " + fault;
}

std::string reduceImage(vtkImageData* image, int largestSide, const Progress& progress, vtkImageData* reduced) {
  const int* size = image->GetDimensions();
  const double scale = std::min(1.0, static_cast<double>(largestSide) / std::max(size[0], size[1]));
  const int width = std::max(1, static_cast<int>(std::lround(scale * size[0])));
  const int height = std::max(1, static_cast<int>(std::lround(scale * size[1])));
  vtkNew<vtkStructuredGrid> whole;
  writeWarpMesh(evenMesh(2, 2, size[0], size[1]), whole);
  vtkNew<vtkImageMeshWarpFilter> warp;
  warp->SetInputData(image);
  warp->SetSourceMeshData(whole);
  warp->SetTargetMeshData(whole);
  warp->SetOutputSize(width, height);
  const std::string fault = runWarp(warp, progress);
  if (!fault.empty()) return fault;
  reduced->ShallowCopy(warp->GetOutput());
  makeColours(reduced);
  return {};
}

}  // namespace mien
