#include "vtkPatchContinuityFilter.h"

#include <algorithm>

#include "FaceCurves.h"
#include "FaceSeams.h"
#include "SeamColumns.h"
#include "SurfaceMesh.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkPatchContinuityFilter);

namespace {

using mien::FaceSeams;
using mien::SeamMeasures;

constexpr int minimumSamples = 3;
constexpr int maximumSamples = 20000;

struct PointArray {
  const char* name;
  double SeamMeasures::*measure;
};
constexpr PointArray pointArrays[] = {{"G0", &SeamMeasures::g0},
                                      {"G1", &SeamMeasures::g1},
                                      {"C1", &SeamMeasures::c1},
                                      {"G2", &SeamMeasures::g2},
                                      {"C2", &SeamMeasures::c2}};

/// The polylines of seams first .. last - 1.
struct SeamLines {
  const FaceSeams& seams;
  int first, last;

  void fill(vtkPolyData* output) const {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> lines;
    vtkNew<vtkStringArray> names;
    names->SetName("SeamName");
    for (int seam = first; seam < last; ++seam) {
      this->addLine(seam, points, lines);
      names->InsertNextValue(FaceSeams::name(seam));
    }
    output->SetPoints(points);
    output->SetLines(lines);
    output->GetCellData()->AddArray(names);
    for (const PointArray& array : pointArrays)
      this->addArray(array.name, output, [&](int seam, int i) { return seams.measures(seam, i).*array.measure; });
    this->addArray("V", output, [&](int, int i) { return seams.v(i); });
  }

  void addLine(int seam, vtkPoints* points, vtkCellArray* lines) const {
    const vtkIdType begin = points->GetNumberOfPoints();
    lines->InsertNextCell(seams.columnCount() + 1);
    for (int i = 0; i < seams.columnCount(); ++i)
      lines->InsertCellPoint(points->InsertNextPoint(seams.position(seam, i).data()));
    lines->InsertCellPoint(begin);
  }

  template <class Value>
  void addArray(const char* name, vtkPolyData* output, Value value) const {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfValues(output->GetNumberOfPoints());
    double* next = array->GetPointer(0);
    for (int seam = first; seam < last; ++seam)
      for (int i = 0; i < seams.columnCount(); ++i) *next++ = value(seam, i);
    output->GetPointData()->AddArray(array);
  }
};

using Summaries = std::vector<mien::SeamSummary>;

void addColumns(const std::string& prefix, const Summaries& rows, vtkTable* table) {
  for (const mien::SeamColumn& column : mien::seamColumns) {
    vtkNew<vtkDoubleArray> values;
    values->SetName((prefix + column.name).c_str());
    for (const mien::SeamSummary& row : rows) values->InsertNextValue(column.of(row));
    table->AddColumn(values);
  }
}

void fillSummary(const FaceSeams& seams, vtkTable* table) {
  vtkNew<vtkStringArray> names;
  names->SetName("seam");
  Summaries whole, frontal;
  mien::SeamSummary all, allFrontal;
  for (int seam = 0; seam < FaceSeams::seamCount; ++seam) {
    names->InsertNextValue(FaceSeams::name(seam));
    whole.push_back(seams.whole(seam));
    frontal.push_back(seams.frontal(seam));
    all.add(whole.back());
    allFrontal.add(frontal.back());
  }
  names->InsertNextValue("all");
  whole.push_back(all);
  frontal.push_back(allFrontal);
  table->AddColumn(names);
  addColumns("", whole, table);
  addColumns("frontal_", frontal, table);
}

}  // namespace

/// The operators of the last update and what they were made for.
struct vtkPatchContinuityFilter::Internals {
  std::unique_ptr<FaceSeams> seams;
  mien::FaceSurfaceOptions options;
  int pointsPerCurve = 0;

  void prepare(const mien::FaceSurfaceOptions& wanted, int points, int samples) {
    if (seams && options == wanted && pointsPerCurve == points && seams->columnCount() == samples) return;
    seams = std::make_unique<FaceSeams>(wanted, points, samples);
    options = wanted;
    pointsPerCurve = points;
  }
};

vtkPatchContinuityFilter::vtkPatchContinuityFilter() : Impl(new Internals) {
  this->SetNumberOfOutputPorts(2);
}

vtkPatchContinuityFilter::~vtkPatchContinuityFilter() = default;

vtkPolyData* vtkPatchContinuityFilter::GetOutput() {
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(0));
}

vtkTable* vtkPatchContinuityFilter::GetSummary() {
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

int vtkPatchContinuityFilter::FillOutputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

bool vtkPatchContinuityFilter::CheckSamples() {
  if (this->NumberOfSamples >= minimumSamples && this->NumberOfSamples <= maximumSamples) return true;
  vtkErrorMacro(<< this->NumberOfSamples << " samples per seam are outside " << minimumSamples << " .. "
                << maximumSamples);
  return false;
}

int vtkPatchContinuityFilter::RequestInformation(vtkInformation*, vtkInformationVector**,
                                                 vtkInformationVector* outputs) {
  if (!this->CheckSamples()) return 0;
  for (int port = 0; port < 2; ++port) outputs->GetInformationObject(port)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

int vtkPatchContinuityFilter::RequestData(vtkInformation* request, vtkInformationVector** inputs,
                                          vtkInformationVector* outputs) {
  mien::FaceCurves face;
  if (!this->CheckSamples() || !this->ReadInput(inputs, face)) return 0;
  this->Impl->prepare(this->GetOptions(), face.curves.pointsPerCurve, this->NumberOfSamples);
  FaceSeams& seams = *this->Impl->seams;
  if (!seams.fault().empty()) {
    vtkErrorMacro(<< seams.fault());
    return 0;
  }
  seams.setCurves(face.curves);
  this->UpdateProgress(0.8);
  if (this->GetAbortExecute()) return 1;
  vtkInformation* info = mien::askedOutput(request, outputs);
  const int piece = info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER());
  const int pieces = std::max(1, info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()));
  const auto share = [&](int i) { return static_cast<int>(static_cast<long long>(FaceSeams::seamCount) * i / pieces); };
  SeamLines{seams, share(piece), share(piece + 1)}.fill(vtkPolyData::GetData(outputs, 0));
  if (!mien::isLaterPiece(request, outputs)) fillSummary(seams, vtkTable::GetData(outputs, 1));
  return 1;
}

void vtkPatchContinuityFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
}
