#include "vtkPDEModeFilter.h"

#include <cmath>

#include "FaceCurves.h"
#include "ModeSpectrum.h"
#include "SurfaceMesh.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkStructuredGrid.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkPDEModeFilter);

namespace {

using mien::ModeMeasures;

struct Column {
  const char* name;
  double ModeMeasures::*value;
};
constexpr Column columns[] = {{"rms_mm", &ModeMeasures::rms},
                              {"max_mm", &ModeMeasures::max},
                              {"energy_share", &ModeMeasures::energyShare},
                              {"cumulative_rms_error_mm", &ModeMeasures::cumulativeError}};

void fillTable(const std::vector<ModeMeasures>& modes, vtkTable* table) {
  vtkNew<vtkStringArray> names;
  names->SetName("mode");
  for (const ModeMeasures& mode : modes) names->InsertNextValue(mode.mode);
  table->AddColumn(names);
  for (const Column& column : columns) {
    vtkNew<vtkDoubleArray> values;
    values->SetName(column.name);
    for (const ModeMeasures& mode : modes) values->InsertNextValue(mode.*column.value);
    table->AddColumn(values);
  }
}

/// The part of a contribution that the grid's extent covers, in the precision of its points.
void addContribution(const mien::RowMajor<double>& whole, vtkStructuredGrid* grid) {
  int extent[6];
  grid->GetExtent(extent);
  const auto array =
      vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(grid->GetPoints()->GetDataType()));
  array->SetName("Contribution");
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(grid->GetNumberOfPoints());
  vtkIdType next = 0;
  for (int row = extent[2]; row <= extent[3]; ++row)
    for (int column = extent[0]; column <= extent[1]; ++column)
      array->SetTuple(next++, whole.row(row).data() + 3 * column);
  grid->GetPointData()->AddArray(array);
}

/// The closing column is computed at v = 0, so that it repeats the first to the bit.
Eigen::VectorXd closedColumns(int count) {
  Eigen::VectorXd v(count + 1);
  for (int i = 0; i <= count; ++i) v[i] = 2.0 * M_PI * (i % count) / count;
  return v;
}

}  // namespace

/// The operators of the last update and what they were made for.
struct vtkPDEModeFilter::Internals {
  std::unique_ptr<mien::ModeSpectrum> spectrum;
  mien::FaceSurfaceOptions options;
  int rows = 0, columns = 0, pointsPerCurve = 0;
  bool uniform = false;

  void prepare(const mien::FaceSurfaceOptions& wanted, int wantedRows, int wantedColumns, bool wantedUniform,
               int points) {
    if (spectrum && options == wanted && rows == wantedRows && columns == wantedColumns && uniform == wantedUniform &&
        pointsPerCurve == points)
      return;
    spectrum = std::make_unique<mien::ModeSpectrum>(wanted, mien::RowLayout(wantedRows, wantedUniform), points,
                                                    closedColumns(wantedColumns));
    options = wanted;
    rows = wantedRows;
    columns = wantedColumns;
    uniform = wantedUniform;
    pointsPerCurve = points;
  }
};

vtkPDEModeFilter::vtkPDEModeFilter() : Impl(new Internals) {
  this->SetNumberOfOutputPorts(2);
}

vtkPDEModeFilter::~vtkPDEModeFilter() = default;

vtkTable* vtkPDEModeFilter::GetSpectrum() {
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

int vtkPDEModeFilter::FillOutputPortInformation(int port, vtkInformation* info) {
  if (port == 0) return this->Superclass::FillOutputPortInformation(port, info);
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

bool vtkPDEModeFilter::CheckMode() {
  const mien::FaceSurfaceOptions& options = this->GetOptions();
  if (this->Mode == -1 && !options.remainder)
    vtkErrorMacro(<< "mode -1 is the remainder, and the surface has none; switch the remainder on or choose a mode");
  else if (this->Mode < -1 || this->Mode > options.modes)
    vtkErrorMacro(<< "mode " << this->Mode << " is outside 0 .. " << options.modes << ", or -1 for the remainder");
  else
    return true;
  return false;
}

int vtkPDEModeFilter::RequestData(vtkInformation* request, vtkInformationVector** inputs,
                                  vtkInformationVector* outputs) {
  mien::FaceCurves face;
  if (!this->CheckResolution() || !this->CheckMode() || !this->ReadInput(inputs, face)) return 0;
  const mien::FaceSurfaceOptions& options = this->GetOptions();
  this->Impl->prepare(options, this->GetNumberOfRows(), this->GetNumberOfColumns(), this->GetUniformRows(),
                      face.curves.pointsPerCurve);
  mien::ModeSpectrum& spectrum = *this->Impl->spectrum;
  if (!spectrum.fault().empty()) {
    vtkErrorMacro(<< spectrum.fault());
    return 0;
  }
  spectrum.setCurves(face.curves);
  double progress = 0.0;
  const std::vector<ModeMeasures> measures = spectrum.measures([&] {
    this->UpdateProgress(progress += 0.5 / spectrum.partCount());
    return !this->GetAbortExecute();
  });
  mien::FaceSurfaceOptions shown = options;
  if (this->PartialSum && this->Mode >= 0) {
    shown.modes = this->Mode;  // the sum of the first modes is the surface that has no others
    shown.remainder = false;
  }
  if (!measures.empty() && !this->MakeSurface(face, shown, outputs)) return 0;
  vtkStructuredGrid* output = vtkStructuredGrid::GetData(outputs);
  if (this->GetAbortExecute()) {
    output->Initialize();  // an abort that came after the last row leaves no half output either
    return 1;
  }
  if (output->GetNumberOfPoints() > 0)
    addContribution(spectrum.contribution(this->Mode < 0 ? options.modes + 1 : this->Mode), output);
  if (!mien::isLaterPiece(request, outputs)) fillTable(measures, vtkTable::GetData(outputs, 1));
  return 1;
}

int vtkPDEModeFilter::FindNumberOfModes(double tolerance) {
  if (!(tolerance >= 0.0)) {
    vtkErrorMacro(<< "a tolerance of " << tolerance << " mm is not a length; give 0 or more");
    return -1;
  }
  int port = 0;
  if (vtkAlgorithm* source = this->GetNumberOfInputConnections(0) > 0 ? this->GetInputAlgorithm(0, 0, port) : nullptr)
    source->Update(port);
  mien::FaceCurves face;
  if (!this->CheckResolution() || !this->ReadInput(this->GetExecutive()->GetInputInformation(), face)) return -1;
  mien::FaceSurfaceOptions options = this->GetOptions();
  options.modes = face.curves.pointsPerCurve / 2;
  const std::string fault = mien::describeFault(options, face.curves.pointsPerCurve);
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return -1;
  }
  // errors are exact in v without sampling it
  mien::ModeSpectrum spectrum(options, mien::RowLayout(this->GetNumberOfRows(), this->GetUniformRows()),
                              face.curves.pointsPerCurve, Eigen::VectorXd::Zero(1));
  if (!spectrum.fault().empty()) {
    vtkErrorMacro(<< spectrum.fault());
    return -1;
  }
  spectrum.setCurves(face.curves);
  return mien::smallestModeCount(spectrum.measures(), tolerance);
}

void vtkPDEModeFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << this->Mode << "\n";
  os << indent << "PartialSum: " << this->PartialSum << "\n";
}
