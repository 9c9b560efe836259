#include "vtkImageMeshWarpFilter.h"

#include "ImageWarp.h"
#include "SurfaceMesh.h"
#include "WarpMeshData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"

vtkStandardNewMacro(vtkImageMeshWarpFilter);

namespace {

using Pipeline = vtkStreamingDemandDrivenPipeline;

std::string describeImageFault(vtkImageData* image) {
  if (!image->GetPointData()->GetScalars() || image->GetNumberOfPoints() == 0)
    return "the image has no scalars to warp";
  if (image->GetScalarType() == VTK_BIT) return "the image has single bits; give it numbers (vtkImageCast)";
  if (image->GetDimensions()[2] != 1) return "the image has several slices; extract one";
  return {};
}

bool isGood(int side) {
  return side >= 1 && side <= vtkImageMeshWarpFilter::LargestSide;
}

}  // namespace

vtkImageMeshWarpFilter::vtkImageMeshWarpFilter() {
  this->SetNumberOfInputPorts(3);
}

void vtkImageMeshWarpFilter::SetSourceMeshData(vtkStructuredGrid* mesh) {
  this->SetInputDataObject(1, mesh);
}

void vtkImageMeshWarpFilter::SetTargetMeshData(vtkStructuredGrid* mesh) {
  this->SetInputDataObject(2, mesh);
}

int vtkImageMeshWarpFilter::FillInputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkImageData" : "vtkStructuredGrid");
  return 1;
}

int vtkImageMeshWarpFilter::RequestInformation(vtkInformation*, vtkInformationVector** inputs,
                                               vtkInformationVector* outputs) {
  int size[2] = {this->OutputSize[0], this->OutputSize[1]}, whole[6];
  inputs[0]->GetInformationObject(0)->Get(Pipeline::WHOLE_EXTENT(), whole);
  for (int axis = 0; axis < 2; ++axis)
    if (size[axis] == 0) size[axis] = whole[2 * axis + 1] - whole[2 * axis] + 1;
  if (!isGood(size[0]) || !isGood(size[1])) {
    vtkErrorMacro(<< "an output of " << size[0] << " x " << size[1] << " pixels is not possible; 1 to " << LargestSide
                  << " are allowed");
    return 0;
  }
  const int extent[6] = {0, size[0] - 1, 0, size[1] - 1, 0, 0};
  vtkInformation* info = outputs->GetInformationObject(0);
  info->Set(Pipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::SPACING(), 1.0, 1.0, 1.0);
  info->Set(vtkDataObject::ORIGIN(), 0.0, 0.0, 0.0);
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  return 1;
}

int vtkImageMeshWarpFilter::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*) {
  for (int port = 0; port < 3; ++port) mien::requestWhole(inputs[port]->GetInformationObject(0));
  return 1;
}

int vtkImageMeshWarpFilter::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) {
  vtkImageData* image = vtkImageData::GetData(inputs[0]);
  vtkImageData* output = vtkImageData::GetData(outputs);
  int whole[6];
  outputs->GetInformationObject(0)->Get(Pipeline::WHOLE_EXTENT(), whole);
  mien::WarpMesh source, target;
  mien::MeshWarp warp;
  std::string fault = describeImageFault(image);
  if (fault.empty()) fault = mien::readWarpMesh(vtkStructuredGrid::GetData(inputs[1]), source);
  if (fault.empty()) fault = mien::readWarpMesh(vtkStructuredGrid::GetData(inputs[2]), target);
  if (fault.empty())
    fault = warp.set(source, target, {image->GetDimensions()[0], image->GetDimensions()[1]},
                     {whole[1] + 1, whole[3] + 1}, this->Closed);
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return 0;
  }
  int extent[6];
  outputs->GetInformationObject(0)->Get(Pipeline::UPDATE_EXTENT(), extent);
  output->SetExtent(extent);
  if (!mien::warpImage(warp, image, this->Closed, this, output)) output->Initialize();
  return 1;
}

void vtkImageMeshWarpFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OutputSize: " << this->OutputSize[0] << " x " << this->OutputSize[1] << "\n";
  os << indent << "Closed: " << this->Closed << "\n";
}
