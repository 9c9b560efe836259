#include "vtkPDEParameterSweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "BreakdownSearch.h"
#include "FaceCurves.h"
#include "FoldedCells.h"
#include "NumberRange.h"
#include "SmoothingSweep.h"
#include "SurfaceDistance.h"
#include "SurfaceMesh.h"
#include "SweepBreakdown.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkPDEParameterSweep);

namespace {

constexpr const char* defaultRange = "0.1:10:21log";
constexpr const char* distanceColumn = "distance_rms_mm";
constexpr double notComputed = std::numeric_limits<double>::quiet_NaN();

/// Area-weighted RMS distance of the front of a face, mm.
double frontalDistance(const mien::FaceSample& sample, const mien::SurfaceDistance& distance) {
  const auto frontalArea = [&](int row, int column) {
    return sample.point(row, column).z() > mien::FoldedCells::frontalZ ? sample.areaElement(row, column) : 0.0;
  };
  const double squared = mien::integrate(sample, [&](int row, int column) {
    const double area = frontalArea(row, column);
    const double d = area > 0.0 ? distance(sample.point(row, column).data(), false) : 0.0;
    return area * d * d;
  });
  return std::sqrt(squared / mien::integrate(sample, frontalArea));
}

/// @return nothing, also without a reference, or one sentence that says why it is no surface
std::string readReference(vtkDataObject* reference, std::unique_ptr<mien::SurfaceDistance>& distance) {
  if (!reference) return {};
  mien::SurfaceMesh mesh;
  const std::string fault = mien::readSurface(reference, "reference mesh", false, mesh);
  if (fault.empty()) distance = std::make_unique<mien::SurfaceDistance>(mesh.triangles);
  return fault;
}

void addTexts(const char* name, const std::vector<mien::SweepRecord>& records, std::string mien::SweepRecord::*text,
              vtkTable* table) {
  vtkNew<vtkStringArray> column;
  column->SetName(name);
  for (const mien::SweepRecord& record : records) column->InsertNextValue(record.*text);
  table->AddColumn(column);
}

template <class Function>
void addNumbers(const std::string& name, const std::vector<mien::SweepRecord>& records, const Function& value,
                vtkTable* table) {
  vtkNew<vtkDoubleArray> column;
  column->SetName(name.c_str());
  for (const mien::SweepRecord& record : records) column->InsertNextValue(value(record));
  table->AddColumn(column);
}

void fillTable(const std::vector<mien::SweepRecord>& records, bool withDistance, vtkTable* table) {
  addTexts("scheme", records, &mien::SweepRecord::scheme, table);
  addNumbers(
      "a", records, [](const mien::SweepRecord& record) { return record.smoothing; }, table);
  const std::vector<std::string>& names = mien::sweepMeasureNames();
  for (size_t i = 0; i < names.size(); ++i)
    if (withDistance || names[i] != distanceColumn)
      addNumbers(
          names[i], records, [i](const mien::SweepRecord& record) { return record.values[i]; }, table);
  addTexts("reason", records, &mien::SweepRecord::reason, table);
}

}  // namespace

struct vtkPDEParameterSweep::Internals {
  std::vector<mien::SweepBreakdown> breakdowns;

  const mien::SweepBreakdown* find(const std::string& scheme) const {
    for (const mien::SweepBreakdown& breakdown : breakdowns)
      if (breakdown.scheme == scheme && breakdown.found) return &breakdown;
    return nullptr;
  }
};

vtkPDEParameterSweep::vtkPDEParameterSweep() : Impl(new Internals) {
  this->SetNumberOfInputPorts(2);
  mien::parseNumberRange(defaultRange, this->SmoothingValues);
}

vtkPDEParameterSweep::~vtkPDEParameterSweep() = default;

vtkTable* vtkPDEParameterSweep::GetOutput() {
  return vtkTable::SafeDownCast(this->GetOutputDataObject(0));
}

void vtkPDEParameterSweep::AddScheme(const std::string& name) {
  this->Schemes.push_back(name);
  this->Modified();
}

void vtkPDEParameterSweep::AddAllSchemes() {
  for (const std::string& name : GetSchemeNames()) this->AddScheme(name);
}

void vtkPDEParameterSweep::ClearSchemes() {
  this->Schemes.clear();
  this->Modified();
}

void vtkPDEParameterSweep::SetSmoothingValues(const std::vector<double>& values) {
  if (values == this->SmoothingValues) return;
  this->SmoothingValues = values;
  this->Modified();
}

void vtkPDEParameterSweep::SetSmoothingRange(const std::string& text) {
  std::vector<double> values;
  const std::string fault = mien::parseNumberRange(text, values);
  if (fault.empty())
    this->SetSmoothingValues(values);
  else
    vtkErrorMacro(<< fault);
}

void vtkPDEParameterSweep::SetResolution(int rows, int columns) {
  if (rows == this->NumberOfRows && columns == this->NumberOfColumns) return;
  this->NumberOfRows = rows;
  this->NumberOfColumns = columns;
  this->Modified();
}

double vtkPDEParameterSweep::GetBreakdown(const std::string& scheme) const {
  const mien::SweepBreakdown* breakdown = this->Impl->find(scheme);
  return breakdown ? breakdown->smoothing : notComputed;
}

std::string vtkPDEParameterSweep::GetBreakdownReason(const std::string& scheme) const {
  const mien::SweepBreakdown* breakdown = this->Impl->find(scheme);
  return breakdown ? breakdown->reason : std::string();
}

int vtkPDEParameterSweep::FillInputPortInformation(int port, vtkInformation* info) {
  if (port == 0) return this->Superclass::FillInputPortInformation(port, info);
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkStructuredGrid");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkPDEParameterSweep::FillOutputPortInformation(int, vtkInformation* info) {
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

int vtkPDEParameterSweep::RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputs,
                                              vtkInformationVector* outputs) {
  mien::requestWhole(inputs[1]->GetInformationObject(0));
  return this->Superclass::RequestUpdateExtent(request, inputs, outputs);
}

mien::SmoothingSweepOptions vtkPDEParameterSweep::MakeSweep() const {
  mien::SmoothingSweepOptions sweep;
  sweep.surface = this->GetOptions();
  sweep.schemes = this->Schemes.empty() ? std::vector<std::string>{this->GetScheme()} : this->Schemes;
  sweep.smoothing = this->SmoothingValues;
  sweep.reference = this->ReferenceSmoothing;
  sweep.rows = this->NumberOfRows;
  sweep.columns = this->NumberOfColumns;
  sweep.threads = this->NumberOfThreads > 0 ? this->NumberOfThreads : vtkSMPTools::GetEstimatedNumberOfThreads();
  return sweep;
}

int vtkPDEParameterSweep::RequestData(vtkInformation* request, vtkInformationVector** inputs,
                                      vtkInformationVector* outputs) {
  this->Impl->breakdowns.clear();
  if (mien::isLaterPiece(request, outputs)) return 1;
  mien::FaceCurves face;
  if (!this->ReadCurves(inputs, face)) return 0;
  mien::SmoothingSweepOptions sweep = this->MakeSweep();
  std::unique_ptr<mien::SurfaceDistance> distance;
  std::string fault = mien::describeFault(sweep, face.curves.pointsPerCurve);
  if (fault.empty()) fault = readReference(vtkDataObject::GetData(inputs[1]), distance);
  if (!fault.empty()) return this->Refuse(fault);
  if (distance) sweep.distance = [&](const mien::FaceSample& sample) { return frontalDistance(sample, *distance); };
  const auto records = mien::smoothingSweep(face, sweep, [this](double share) {
    this->UpdateProgress(share);
    return !this->GetAbortExecute();
  });
  if (!records) return 1;
  this->FindBreakdowns(face, sweep, *records);
  if (this->GetAbortExecute()) return 1;
  fillTable(*records, distance != nullptr, vtkTable::GetData(outputs));
  return 1;
}

void vtkPDEParameterSweep::FindBreakdowns(const mien::FaceCurves& face, const mien::SmoothingSweepOptions& sweep,
                                          const std::vector<mien::SweepRecord>& records) {
  const double least = *std::min_element(sweep.smoothing.begin(), sweep.smoothing.end());
  mien::BreakdownSearch search(face, sweep.surface, least);
  search.setProgress([this] { return !this->GetAbortExecute(); });
  this->Impl->breakdowns = mien::findBreakdowns(records);
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Impl->breakdowns.size()), 1, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i) this->Impl->breakdowns[i] = search.refine(this->Impl->breakdowns[i]);
  });
}

int vtkPDEParameterSweep::Refuse(const std::string& fault) {
  vtkErrorMacro(<< fault);
  return 0;
}

void vtkPDEParameterSweep::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Schemes:";
  for (const std::string& scheme : this->Schemes) os << " " << scheme;
  os << "\n" << indent << "SmoothingValues:";
  for (const double a : this->SmoothingValues) os << " " << a;
  os << "\n" << indent << "ReferenceSmoothing: " << this->ReferenceSmoothing << "\n";
  os << indent << "NumberOfRows: " << this->NumberOfRows << "\n";
  os << indent << "NumberOfColumns: " << this->NumberOfColumns << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
}
