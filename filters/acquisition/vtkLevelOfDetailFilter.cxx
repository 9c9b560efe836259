#include "vtkLevelOfDetailFilter.h"

#include <algorithm>

#include "FaceCurves.h"
#include "LevelsOfDetail.h"
#include "MeshData.h"
#include "SurfaceMesh.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkLevelOfDetailFilter);

namespace {

using Record = mien::DetailRecord;

template <class Array, class Function>
void addColumn(const char* name, const std::vector<Record>& records, vtkTable* table, const Function& value) {
  vtkNew<Array> column;
  column->SetName(name);
  for (const Record& record : records) column->InsertNextValue(value(record));
  table->AddColumn(column);
}

/// The scan itself has no distance: its numbers are zeros.
void fillTable(const std::vector<Record>& records, vtkTable* table) {
  addColumn<vtkStringArray>("representation", records, table, [](const Record& r) { return r.representation; });
  addColumn<vtkStringArray>("detail", records, table, [](const Record& r) { return r.detail; });
  addColumn<vtkIdTypeArray>("bytes", records, table, [](const Record& r) { return r.bytes; });
  addColumn<vtkIdTypeArray>("triangles", records, table, [](const Record& r) { return r.triangles; });
  addColumn<vtkDoubleArray>("rms_mm", records, table, [](const Record& r) { return r.rms; });
  addColumn<vtkDoubleArray>("max_mm", records, table, [](const Record& r) { return r.maximum; });
  addColumn<vtkDoubleArray>("back_rms_mm", records, table, [](const Record& r) { return r.backRMS; });
  addColumn<vtkDoubleArray>("back_max_mm", records, table, [](const Record& r) { return r.backMaximum; });
  addColumn<vtkDoubleArray>("symmetric_rms_mm", records, table,
                            [](const Record& r) { return std::max(r.rms, r.backRMS); });
  addColumn<vtkDoubleArray>("hausdorff_mm", records, table,
                            [](const Record& r) { return std::max(r.maximum, r.backMaximum); });
  addColumn<vtkDoubleArray>("curves_rms_mm", records, table, [](const Record& r) { return r.curvesRMS; });
}

}  // namespace

vtkLevelOfDetailFilter::vtkLevelOfDetailFilter() : Tolerances(mien::DetailOptions().tolerances) {
  this->SetNumberOfInputPorts(2);
}

vtkTable* vtkLevelOfDetailFilter::GetOutput() {
  return vtkTable::SafeDownCast(this->GetOutputDataObject(0));
}

void vtkLevelOfDetailFilter::SetTolerances(const std::vector<double>& tolerances) {
  if (tolerances == this->Tolerances) return;
  this->Tolerances = tolerances;
  this->Modified();
}

int vtkLevelOfDetailFilter::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkLevelOfDetailFilter::FillOutputPortInformation(int, vtkInformation* info) {
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

/// Whole curves and the whole scan, whatever piece of the table is wanted.
int vtkLevelOfDetailFilter::RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputs,
                                                vtkInformationVector* outputs) {
  mien::requestWhole(inputs[1]->GetInformationObject(0));
  return this->Superclass::RequestUpdateExtent(request, inputs, outputs);
}

int vtkLevelOfDetailFilter::RequestData(vtkInformation* request, vtkInformationVector** inputs,
                                        vtkInformationVector* outputs) {
  if (mien::isLaterPiece(request, outputs)) return 1;
  mien::FaceCurves face;
  if (!this->ReadInput(inputs, face)) return 0;
  mien::DetailOptions options;
  options.surface = this->GetOptions();
  options.tolerances = this->Tolerances;
  options.frontalThreshold = this->FrontalThreshold;
  options.spacing = this->SampleSpacing;
  mien::TriangleMesh scan;
  std::vector<mien::DetailRecord> records;
  std::string fault = mien::readTriangleMesh(vtkPolyData::GetData(inputs[1]), scan);
  if (fault.empty())
    fault = mien::measureLevelsOfDetail(
        face, scan, options,
        [this](double done) {
          this->UpdateProgress(done);
          return !this->GetAbortExecute();
        },
        records);
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return 0;
  }
  if (!records.empty()) fillTable(records, vtkTable::GetData(outputs));
  return 1;
}

void vtkLevelOfDetailFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerances:";
  for (const double tolerance : this->Tolerances) os << " " << tolerance;
  os << "\n" << indent << "FrontalThreshold: " << this->FrontalThreshold << "\n";
  os << indent << "SampleSpacing: " << this->SampleSpacing << "\n";
}
