#include "vtkFDTFitFilter.h"

#include "FDTData.h"
#include "FaceFrame.h"
#include "SurfaceMesh.h"
#include "TableFit.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkFDTFitFilter);

namespace {

/// Which points take part: neither the pupils nor, on a mesh, what is not wholly on the face.
std::vector<vtkIdType> chosenPoints(vtkPointSet* data, const mien::FaceFrame& frame,
                                    const mien::FaceFrameOptions& options, const mien::FacialRegions& regions) {
  vtkStringArray* names = mien::markerNames(data);
  std::vector<vtkIdType> chosen;
  for (std::size_t i = 0; i < frame.points.size(); ++i) {
    const Eigen::Vector3d place = frame.pupils.apply(frame.points[i].position);
    const bool face = !frame.isMesh || mien::isFitted(regions, place, frame.points[i]);
    const bool pupil =
        names && (names->GetValue(i) == options.leftPupilName || names->GetValue(i) == options.rightPupilName);
    if (face && !pupil) chosen.push_back(static_cast<vtkIdType>(i));
  }
  return chosen;
}

mien::TableSamples samplesOf(const mien::FaceFrame& before, const mien::FaceFrame& after,
                             const std::vector<vtkIdType>& chosen, const mien::FacialRegions& regions) {
  mien::TableSamples samples;
  samples.before.resize(chosen.size(), 2);
  samples.after.resize(chosen.size(), 2);
  for (std::size_t row = 0; row < chosen.size(); ++row) {
    const mien::DeformationPoint& point = before.points[chosen[row]];
    samples.before.row(row) = before.pupils.apply(point.position).head<2>().transpose();
    samples.after.row(row) = after.pupils.apply(after.points[chosen[row]].position).head<2>().transpose();
    samples.regions.push_back(point.region ? point.region : regions.nearest(samples.before.row(row), point.side));
  }
  return samples;
}

std::string ofState(const char* state, const std::string& text) {
  return text.empty() ? text : state + (": " + text);
}

void addColumn(vtkTable* table, const char* name, const mien::TableFit& fit,
               double (*value)(const mien::QuadraticFit&)) {
  vtkNew<vtkDoubleArray> column;
  column->SetName(name);
  for (const mien::QuadraticFit& region : fit.regions) column->InsertNextValue(value(region));
  table->AddColumn(column);
}

}  // namespace

vtkFDTFitFilter::vtkFDTFitFilter() {
  this->SetNumberOfInputPorts(2);
}

vtkTable* vtkFDTFitFilter::GetOutput() {
  return vtkTable::SafeDownCast(this->GetOutputDataObject(0));
}

int vtkFDTFitFilter::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

int vtkFDTFitFilter::FillOutputPortInformation(int, vtkInformation* info) {
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

int vtkFDTFitFilter::RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) {
  if (!vtkTable::GetData(outputs))
    outputs->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), vtkNew<vtkTable>());
  return 1;
}

int vtkFDTFitFilter::RequestData(vtkInformation* request, vtkInformationVector** inputs,
                                 vtkInformationVector* outputs) {
  if (mien::isLaterPiece(request, outputs)) return 1;
  vtkPointSet *neutral = vtkPointSet::GetData(inputs[0]), *expression = vtkPointSet::GetData(inputs[1]);
  mien::FaceFrameOptions options = this->GetFrameOptions();
  // The chin's way down turns the pose that landmarks tell: two states must not be turned by different poses.
  options.turnsToFront = false;
  mien::FaceFrameOptions others = options;
  others.leftPupil = Eigen::Map<const Eigen::Vector3d>(this->OtherLeftPupil);
  others.rightPupil = Eigen::Map<const Eigen::Vector3d>(this->OtherRightPupil);
  mien::FacialRegions regions;
  mien::FaceFrame before, after;
  mien::TableFit fit;
  std::string fault = mien::readRegions(this->GetRegionFileName(), regions);
  if (fault.empty() && neutral->GetNumberOfPoints() != expression->GetNumberOfPoints())
    fault = "the neutral face has " + std::to_string(neutral->GetNumberOfPoints()) + " points and the expression " +
            std::to_string(expression->GetNumberOfPoints()) + "; give the same points before and after";
  if (fault.empty() && neutral->GetNumberOfPoints() == 0) fault = "there are no points; give a face before and after";
  if (fault.empty())
    fault = ofState("neutral face", mien::readFaceFrame(neutral, options, regions, before, ReportProgress(0.0, 0.45)));
  if (fault.empty())
    fault = ofState("expression", mien::readFaceFrame(expression, others, regions, after, ReportProgress(0.45, 0.9)));
  if (this->GetAbortExecute()) return 1;
  if (fault.empty())
    fault = fit.fit(samplesOf(before, after, chosenPoints(neutral, before, options, regions), regions),
                    {this->Strict, this->AllowEmptyRegions});
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return 0;
  }
  const std::string aside = ofState("neutral face", before.warning) + ofState("expression", after.warning);
  if (!aside.empty()) vtkWarningMacro(<< aside);
  this->RMS = fit.rms;
  this->Warning = fit.warning();
  if (!this->Warning.empty()) vtkWarningMacro(<< this->Warning);
  vtkTable* table = vtkTable::GetData(outputs);
  mien::writeFDT(fit.table, table);
  addColumn(table, "points", fit, [](const mien::QuadraticFit& region) { return double(region.points); });
  addColumn(table, "rank", fit, [](const mien::QuadraticFit& region) { return double(region.rank); });
  addColumn(table, "rms", fit, [](const mien::QuadraticFit& region) { return region.rms; });
  return 1;
}

void vtkFDTFitFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OtherLeftPupil: " << this->OtherLeftPupil[0] << " " << this->OtherLeftPupil[1] << " "
     << this->OtherLeftPupil[2] << "\n";
  os << indent << "OtherRightPupil: " << this->OtherRightPupil[0] << " " << this->OtherRightPupil[1] << " "
     << this->OtherRightPupil[2] << "\n";
  os << indent << "Strict: " << (this->Strict ? "on" : "off") << "\n";
  os << indent << "AllowEmptyRegions: " << (this->AllowEmptyRegions ? "on" : "off") << "\n";
  os << indent << "RMS: " << this->RMS << "\n";
}
