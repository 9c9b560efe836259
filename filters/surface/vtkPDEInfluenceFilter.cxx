#include "vtkPDEInfluenceFilter.h"

#include <algorithm>
#include <limits>

#include "FaceCurves.h"
#include "SurfaceInfluence.h"
#include "SurfaceMesh.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkPDEInfluenceFilter);

/// So that the class's header needs no Eigen.
struct mien::InfluenceGrid {
  const RowMajor<double>& values;
};

namespace {

constexpr int portOfProfile = 1;
constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

/// The part that the grid's extent covers; the last column repeats the first, as the grid's points do.
vtkSmartPointer<vtkDoubleArray> influenceArray(const mien::RowMajor<double>& influence, const double direction[3],
                                               vtkStructuredGrid* grid) {
  double unit[3] = {direction[0], direction[1], direction[2]};
  vtkMath::Normalize(unit);
  int extent[6];
  grid->GetExtent(extent);
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName("Influence");
  array->SetNumberOfComponents(3);
  for (int row = extent[2]; row <= extent[3]; ++row)
    for (int column = extent[0]; column <= extent[1]; ++column) {
      const double length = influence(row, column % influence.cols());
      array->InsertNextTuple3(length * unit[0], length * unit[1], length * unit[2]);
    }
  return array;
}

void fillProfile(const mien::InfluenceProfile& profile, vtkTable* table) {
  vtkNew<vtkIntArray> rows;
  vtkNew<vtkDoubleArray> curves, largest;
  rows->SetName("row");
  curves->SetName("curve");
  largest->SetName("influence_max");
  for (size_t row = 0; row < profile.largest.size(); ++row) {
    rows->InsertNextValue(static_cast<int>(row));
    curves->InsertNextValue(profile.position[row] + 1.0);
    largest->InsertNextValue(profile.largest[row]);
  }
  table->AddColumn(rows);
  table->AddColumn(curves);
  table->AddColumn(largest);
}

}  // namespace

struct vtkPDEInfluenceFilter::Internals {
  /// Curves above and below, rows above and below.
  double halfWidths[4] = {undefined, undefined, undefined, undefined};
};

vtkPDEInfluenceFilter::vtkPDEInfluenceFilter() : Impl(new Internals) {
  this->SetNumberOfOutputPorts(2);
  this->SetOutputPointsPrecision(DOUBLE_PRECISION);
}

vtkPDEInfluenceFilter::~vtkPDEInfluenceFilter() = default;

vtkTable* vtkPDEInfluenceFilter::GetProfile() {
  return vtkTable::SafeDownCast(this->GetOutputDataObject(portOfProfile));
}

void vtkPDEInfluenceFilter::SetCurve(const std::string& name) {
  if (name == this->Curve) return;
  this->Curve = name;
  this->Modified();
}

double vtkPDEInfluenceFilter::GetHalfWidthAbove() const {
  return this->Impl->halfWidths[0];
}

double vtkPDEInfluenceFilter::GetHalfWidthBelow() const {
  return this->Impl->halfWidths[1];
}

double vtkPDEInfluenceFilter::GetHalfWidthAboveInRows() const {
  return this->Impl->halfWidths[2];
}

double vtkPDEInfluenceFilter::GetHalfWidthBelowInRows() const {
  return this->Impl->halfWidths[3];
}

int vtkPDEInfluenceFilter::FillOutputPortInformation(int port, vtkInformation* info) {
  if (port != portOfProfile) return this->Superclass::FillOutputPortInformation(port, info);
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

std::string vtkPDEInfluenceFilter::DescribeFault(int pointsPerCurve) const {
  if (mien::FaceLayout::curveIndex(this->Curve) < 0)
    return "there is no curve '" + this->Curve + "'; the curves are C1 .. C22, C22', C23 .. C28";
  if (this->Point < mien::InfluenceSource::wholeCurve || this->Point >= pointsPerCurve)
    return "curve " + this->Curve + " has no point " + std::to_string(this->Point) + "; its points are 0 .. " +
           std::to_string(pointsPerCurve - 1) + ", and -1 moves the whole curve";
  const double length = vtkMath::Norm(this->Direction);
  if (!(length > 0.0) || !vtkMath::IsFinite(length))
    return "the direction of the move has no length; give a finite vector that is not 0";
  return {};
}

int vtkPDEInfluenceFilter::RequestData(vtkInformation* request, vtkInformationVector** inputs,
                                       vtkInformationVector* outputs) {
  std::fill(this->Impl->halfWidths, this->Impl->halfWidths + 4, undefined);
  mien::FaceCurves face;
  if (!this->CheckResolution() || !this->ReadInput(inputs, face)) return 0;
  std::string fault = this->DescribeFault(face.curves.pointsPerCurve);
  const mien::RowLayout layout(this->GetNumberOfRows(), this->GetUniformRows());
  const mien::InfluenceSource source = {mien::FaceLayout::curveIndex(this->Curve), this->Point};
  mien::RowMajor<double> influence;
  if (fault.empty()) {
    influence = mien::surfaceInfluence(this->GetOptions(), face.curves.pointsPerCurve, layout,
                                       this->GetNumberOfColumns(), source);
    if (influence.size() == 0)
      fault = "the conditions of scheme " + this->GetScheme() + " do not determine a surface; choose another";
  }
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return 0;
  }
  this->UpdateProgress(0.5);
  if (this->GetAbortExecute()) return 1;
  return this->MakeSurface(face, this->GetOptions(), outputs) ? this->FillOutputs({influence}, layout, request, outputs)
                                                              : 0;
}

int vtkPDEInfluenceFilter::FillOutputs(const mien::InfluenceGrid& influence, const mien::RowLayout& layout,
                                       vtkInformation* request, vtkInformationVector* outputs) {
  vtkStructuredGrid* grid = vtkStructuredGrid::GetData(outputs, 0);
  if (this->GetAbortExecute()) {
    grid->Initialize();
    return 1;
  }
  const mien::InfluenceProfile profile(influence.values, layout, mien::FaceLayout::curveIndex(this->Curve));
  const double widths[4] = {profile.curvesAbove, profile.curvesBelow, profile.rowsAbove, profile.rowsBelow};
  std::copy(widths, widths + 4, this->Impl->halfWidths);
  if (grid->GetNumberOfPoints() > 0)
    grid->GetPointData()->AddArray(influenceArray(influence.values, this->Direction, grid));
  if (!mien::isLaterPiece(request, outputs)) fillProfile(profile, vtkTable::GetData(outputs, portOfProfile));
  return 1;
}

void vtkPDEInfluenceFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Curve: " << this->Curve << "\n";
  os << indent << "Point: " << this->Point << "\n";
  os << indent << "Direction: " << this->Direction[0] << " " << this->Direction[1] << " " << this->Direction[2] << "\n";
}
