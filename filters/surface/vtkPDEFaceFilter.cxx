#include "vtkPDEFaceFilter.h"

#include <algorithm>
#include <cmath>

#include "BoundaryCurveData.h"
#include "FaceSurface.h"
#include "GridResolution.h"
#include "MouthCorners.h"
#include "SurfaceGrid.h"
#include "SurfaceMesh.h"
#include "vtkAbstractArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"

vtkStandardNewMacro(vtkPDEFaceFilter);

namespace {

/// The grid with everything but its extent.
mien::SurfaceGridLayout faceLayout(const mien::RowLayout& rows, int columns, const mien::FaceCurves& face) {
  mien::SurfaceGridLayout layout;
  for (const mien::FaceRow& row : rows.rows()) layout.faceU.push_back(row.faceU);
  for (size_t i = 1; i < layout.faceU.size(); ++i) layout.patchOfCells.push_back(rows.rows()[i].patch);
  layout.columns = columns;
  layout.slitRow = rows.upperLipRow();
  const mien::MouthCorners mouth(face);
  layout.slitBegin = mouth.begin;
  layout.slitEnd = mouth.end;
  return layout;
}

}  // namespace

struct vtkPDEFaceFilter::Internals {
  /// The operators of the last update and what they were made for.
  std::unique_ptr<mien::SurfaceGrid> grid;
  mien::FaceSurfaceOptions gridOptions;
  mien::SurfaceGridLayout gridLayout;
  int gridPointsPerCurve = 0;
  bool gridDoublePrecision = false;

  bool isFor(const mien::FaceSurfaceOptions& options, const mien::SurfaceGridLayout& layout, int pointsPerCurve,
             bool doublePrecision) const {
    return grid && gridOptions == options && gridLayout == layout && gridPointsPerCurve == pointsPerCurve &&
           gridDoublePrecision == doublePrecision;
  }

  void prepare(const mien::FaceSurfaceOptions& options, const mien::RowLayout& rows,
               const mien::SurfaceGridLayout& layout, int pointsPerCurve, bool doublePrecision) {
    if (isFor(options, layout, pointsPerCurve, doublePrecision)) return;
    const mien::HarmonicSplit split(pointsPerCurve, options.modes, options.remainder);
    grid = mien::SurfaceGrid::make(mien::facePieces(options, rows), split, mien::FaceLayout::curveCount, layout,
                                   doublePrecision);
    gridOptions = options;
    gridLayout = layout;
    gridPointsPerCurve = pointsPerCurve;
    gridDoublePrecision = doublePrecision;
  }
};

vtkPDEFaceFilter::vtkPDEFaceFilter() : Impl(new Internals) {}

vtkPDEFaceFilter::~vtkPDEFaceFilter() = default;

vtkStructuredGrid* vtkPDEFaceFilter::GetOutput() {
  return vtkStructuredGrid::SafeDownCast(this->GetOutputDataObject(0));
}

void vtkPDEFaceFilter::SetResolution(int rows, int columns) {
  if (rows == this->NumberOfRows && columns == this->NumberOfColumns) return;
  this->NumberOfRows = rows;
  this->NumberOfColumns = columns;
  this->Modified();
}

int vtkPDEFaceFilter::FillOutputPortInformation(int, vtkInformation* info) {
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkStructuredGrid");
  return 1;
}

bool vtkPDEFaceFilter::CheckResolution() {
  const auto& describe = this->IsMadeInParts() ? mien::describePartedResolutionFault : mien::describeResolutionFault;
  const std::string fault = describe(this->NumberOfRows, this->NumberOfColumns, mien::RowLayout::minimumRows);
  if (!fault.empty()) vtkErrorMacro(<< fault);
  return fault.empty();
}

int vtkPDEFaceFilter::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) {
  if (!this->CheckResolution()) return 0;
  mien::offerGrid(outputs->GetInformationObject(0), this->NumberOfRows, this->NumberOfColumns);
  return 1;
}

int vtkPDEFaceFilter::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) {
  mien::FaceCurves face;
  // Data may be asked for although the information was refused: a second update does not ask for it again.
  if (!this->CheckResolution() || !this->ReadInput(inputs, face)) return 0;
  if (!this->MakeSurface(face, this->GetOptions(), outputs)) return 0;
  for (const char* name : {"Pupils", "HeadRotation"})
    if (vtkAbstractArray* array = vtkPolyData::GetData(inputs[0])->GetFieldData()->GetAbstractArray(name))
      this->GetOutput()->GetFieldData()->AddArray(array);
  return 1;
}

bool vtkPDEFaceFilter::MakeSurface(const mien::FaceCurves& face, const mien::FaceSurfaceOptions& options,
                                   vtkInformationVector* outputs) {
  const mien::RowLayout rows(this->NumberOfRows, this->UniformRows);
  mien::SurfaceGridLayout layout = faceLayout(rows, this->NumberOfColumns, face);
  layout.curvatures = this->GenerateCurvatures;
  outputs->GetInformationObject(0)->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), layout.extent);
  if (layout.extent[1] < layout.extent[0] || layout.extent[3] < layout.extent[2]) return true;
  std::string fault =
      mien::describePartFault(layout.extent[3] - layout.extent[2] + 1, layout.extent[1] - layout.extent[0]);
  if (fault.empty()) fault = this->FillGrid(face, options, rows, layout, vtkStructuredGrid::GetData(outputs));
  if (!fault.empty()) vtkErrorMacro(<< fault);
  return fault.empty();
}

std::string vtkPDEFaceFilter::FillGrid(const mien::FaceCurves& face, const mien::FaceSurfaceOptions& options,
                                       const mien::RowLayout& rows, const mien::SurfaceGridLayout& layout,
                                       vtkStructuredGrid* output) {
  this->Impl->prepare(options, rows, layout, face.curves.pointsPerCurve,
                      this->OutputPointsPrecision == DOUBLE_PRECISION);
  const std::string fault = this->Impl->grid->fault();
  if (fault.empty()) this->Impl->grid->execute(face.curves, this->GenerateDerivatives, this, output);
  return fault;
}

void vtkPDEFaceFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfRows: " << this->NumberOfRows << "\n";
  os << indent << "NumberOfColumns: " << this->NumberOfColumns << "\n";
  os << indent << "UniformRows: " << this->UniformRows << "\n";
  os << indent << "GenerateDerivatives: " << this->GenerateDerivatives << "\n";
  os << indent << "GenerateCurvatures: " << this->GenerateCurvatures << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
