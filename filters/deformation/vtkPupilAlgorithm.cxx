#include "vtkPupilAlgorithm.h"

#include <algorithm>
#include <array>

#include "FaceFrame.h"
#include "SurfaceMesh.h"
#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"

namespace {

/// The extent of the cells between points; a flat axis has one layer of them.
std::array<int, 6> cellsOf(const int* points) {
  std::array<int, 6> cells;
  for (int axis = 0; axis < 3; ++axis) {
    cells[2 * axis] = points[2 * axis];
    cells[2 * axis + 1] = std::max(points[2 * axis], points[2 * axis + 1] - 1);
  }
  return cells;
}

void copyPart(vtkDataSetAttributes* from, const int* extent, const int* wanted, vtkDataSetAttributes* to) {
  to->CopyAllOn();
  to->CopyAllocate(from);
  to->CopyStructuredData(from, extent, wanted);
}

/// vtkStructuredGrid::Crop() loses the cell data of a flat grid.
void keepPart(vtkStructuredGrid* grid, const int* wanted) {
  int extent[6];
  grid->GetExtent(extent);
  if (std::equal(extent, extent + 6, wanted) || grid->GetNumberOfPoints() == 0) return;
  vtkNew<vtkStructuredGrid> part;
  part->SetExtent(const_cast<int*>(wanted));
  vtkNew<vtkPointData> whole, places;
  whole->SetVectors(grid->GetPoints()->GetData());
  copyPart(whole, extent, wanted, places);
  vtkNew<vtkPoints> points;
  points->SetData(places->GetVectors());
  part->SetPoints(points);
  copyPart(grid->GetPointData(), extent, wanted, part->GetPointData());
  copyPart(grid->GetCellData(), cellsOf(extent).data(), cellsOf(wanted).data(), part->GetCellData());
  part->GetFieldData()->ShallowCopy(grid->GetFieldData());
  grid->ShallowCopy(part);
}

}  // namespace

int vtkPupilAlgorithm::ExecuteInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) {
  vtkInformation* output = outputs->GetInformationObject(0);
  const bool isGrid = output->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
  if (isGrid) output->Set(CAN_PRODUCE_SUB_EXTENT(), 1);
  return 1;
}

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
    keepPart(grid, info->Get(Pipeline::UPDATE_EXTENT()));
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
