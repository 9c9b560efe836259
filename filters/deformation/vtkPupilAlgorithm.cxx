#include "vtkPupilAlgorithm.h"

#include "FaceFrame.h"
#include "SurfaceMesh.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointSet.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"

int vtkPupilAlgorithm::ComputeInputUpdateExtent(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*) {
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
      mien::requestWhole(inputs[port]->GetInformationObject(i));
  return 1;
}

mien::FaceFrameOptions vtkPupilAlgorithm::GetFrameOptions() const {
  mien::FaceFrameOptions options;
  options.leftPupil = Eigen::Map<const Eigen::Vector3d>(this->LeftPupil);
  options.rightPupil = Eigen::Map<const Eigen::Vector3d>(this->RightPupil);
  options.leftPupilName = this->LeftPupilName;
  options.rightPupilName = this->RightPupilName;
  options.landmarkFile = this->LandmarkFileName;
  return options;
}

std::function<bool(double)> vtkPupilAlgorithm::ReportProgress(double from, double to) {
  return [this, from, to](double done) {
    this->UpdateProgress(from + (to - from) * done);
    return !this->GetAbortExecute();
  };
}

void vtkPupilAlgorithm::KeepWantedPart(vtkInformation* info) {
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkPointSet* data = vtkPointSet::GetData(info);
  auto* grid = vtkStructuredGrid::SafeDownCast(data);
  if (grid && info->Has(Pipeline::UPDATE_EXTENT()))
    grid->Crop(info->Get(Pipeline::UPDATE_EXTENT()));
  else if (!grid && info->Has(Pipeline::UPDATE_PIECE_NUMBER()) && info->Get(Pipeline::UPDATE_PIECE_NUMBER()) > 0)
    data->Initialize();
}

void vtkPupilAlgorithm::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LeftPupil: " << this->LeftPupil[0] << " " << this->LeftPupil[1] << " " << this->LeftPupil[2] << "\n";
  os << indent << "RightPupil: " << this->RightPupil[0] << " " << this->RightPupil[1] << " " << this->RightPupil[2]
     << "\n";
  os << indent << "LeftPupilName: " << this->LeftPupilName << "\n";
  os << indent << "RightPupilName: " << this->RightPupilName << "\n";
  os << indent << "LandmarkFileName: " << (this->LandmarkFileName.empty() ? "(none)" : this->LandmarkFileName) << "\n";
  os << indent << "RegionFileName: " << (this->RegionFileName.empty() ? "(none)" : this->RegionFileName) << "\n";
}
