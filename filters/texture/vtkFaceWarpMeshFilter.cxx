#include "vtkFaceWarpMeshFilter.h"

#include "BoundaryCurveData.h"
#include "FaceWarpLayout.h"
#include "SurfaceMesh.h"
#include "WarpMeshData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"

vtkStandardNewMacro(vtkFaceWarpMeshFilter);

int vtkFaceWarpMeshFilter::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkFaceWarpMeshFilter::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) {
  using Kind = mien::FaceWarpLayout::Kind;
  const auto [rows, columns] = mien::FaceWarpLayout::sizeOf(this->Fine ? Kind::Fine : Kind::SevenBySeven);
  const int extent[6] = {0, columns - 1, 0, rows - 1, 0, 0};
  outputs->GetInformationObject(0)->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  return 1;
}

int vtkFaceWarpMeshFilter::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*) {
  mien::requestWhole(inputs[0]->GetInformationObject(0));
  return 1;
}

int vtkFaceWarpMeshFilter::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) {
  using Kind = mien::FaceWarpLayout::Kind;
  mien::FaceCurves face;
  mien::FaceWarpLayout layout;
  std::string fault = mien::readFaceCurves(vtkPolyData::GetData(inputs[0]), face);
  if (fault.empty()) fault = layout.set(this->Fine ? Kind::Fine : Kind::SevenBySeven, face);
  if (fault.empty() && (this->TextureSize[0] < 1 || this->TextureSize[1] < 1))
    fault = "the texture has no size; set one from 1 x 1 up";
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return 0;
  }
  mien::writeWarpMesh(mien::textureMesh(layout, this->TextureSize[0], this->TextureSize[1]),
                      vtkStructuredGrid::GetData(outputs));
  return 1;
}

void vtkFaceWarpMeshFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Fine: " << this->Fine << "\n";
  os << indent << "TextureSize: " << this->TextureSize[0] << " x " << this->TextureSize[1] << "\n";
}
