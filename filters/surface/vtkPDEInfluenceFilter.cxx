#include "vtkPDEInfluenceFilter.h"

#include "FaceCurves.h"
#include "SurfaceInfluence.h"

#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPDEFaceFilter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"
#include "vtkTable.h"

#include <algorithm>
#include <limits>

vtkStandardNewMacro(vtkPDEInfluenceFilter);

namespace
{

constexpr int minimumColumns = 3;
constexpr int portOfProfile = 1;
constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

/// The last column repeats the first, as the grid's points do.
vtkSmartPointer<vtkDoubleArray> influenceArray(const mien::RowMajor<double>& influence, const double direction[3])
{
  double unit[3] = { direction[0], direction[1], direction[2] };
  vtkMath::Normalize(unit);
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName("Influence");
  array->SetNumberOfComponents(3);
  for (Eigen::Index row = 0; row < influence.rows(); ++row)
    for (Eigen::Index column = 0; column <= influence.cols(); ++column)
    {
      const double length = influence(row, column % influence.cols());
      array->InsertNextTuple3(length * unit[0], length * unit[1], length * unit[2]);
    }
  return array;
}

void fillProfile(const mien::InfluenceProfile& profile, vtkTable* table)
{
  vtkNew<vtkIntArray> rows;
  vtkNew<vtkDoubleArray> curves, largest;
  rows->SetName("row");
  curves->SetName("curve");
  largest->SetName("influence_max");
  for (size_t row = 0; row < profile.largest.size(); ++row)
  {
    rows->InsertNextValue(static_cast<int>(row));
    curves->InsertNextValue(profile.position[row] + 1.0);
    largest->InsertNextValue(profile.largest[row]);
  }
  table->AddColumn(rows);
  table->AddColumn(curves);
  table->AddColumn(largest);
}

} // namespace

struct vtkPDEInfluenceFilter::Internals
{
  /// Curves above and below, rows above and below.
  double halfWidths[4] = { undefined, undefined, undefined, undefined };
};

vtkPDEInfluenceFilter::vtkPDEInfluenceFilter()
  : Impl(new Internals)
{
  this->SetNumberOfOutputPorts(2);
}

vtkPDEInfluenceFilter::~vtkPDEInfluenceFilter() = default;

vtkStructuredGrid* vtkPDEInfluenceFilter::GetOutput()
{
  return vtkStructuredGrid::SafeDownCast(this->GetOutputDataObject(0));
}

vtkTable* vtkPDEInfluenceFilter::GetProfile()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(portOfProfile));
}

void vtkPDEInfluenceFilter::SetCurve(const std::string& name)
{
  if (name == this->Curve)
    return;
  this->Curve = name;
  this->Modified();
}

void vtkPDEInfluenceFilter::SetResolution(int rows, int columns)
{
  if (rows == this->NumberOfRows && columns == this->NumberOfColumns)
    return;
  this->NumberOfRows = rows;
  this->NumberOfColumns = columns;
  this->Modified();
}

double vtkPDEInfluenceFilter::GetHalfWidthAbove() const
{
  return this->Impl->halfWidths[0];
}

double vtkPDEInfluenceFilter::GetHalfWidthBelow() const
{
  return this->Impl->halfWidths[1];
}

double vtkPDEInfluenceFilter::GetHalfWidthAboveInRows() const
{
  return this->Impl->halfWidths[2];
}

double vtkPDEInfluenceFilter::GetHalfWidthBelowInRows() const
{
  return this->Impl->halfWidths[3];
}

int vtkPDEInfluenceFilter::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == portOfProfile ? "vtkTable" : "vtkStructuredGrid");
  return 1;
}

int vtkPDEInfluenceFilter::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  if (this->NumberOfRows < mien::RowLayout::minimumRows || this->NumberOfColumns < minimumColumns)
  {
    vtkErrorMacro(<< "a resolution of " << this->NumberOfRows << "x" << this->NumberOfColumns << " is too coarse; at least "
                  << mien::RowLayout::minimumRows << "x" << minimumColumns << " is needed");
    return 0;
  }
  const int extent[6] = { 0, this->NumberOfColumns, 0, this->NumberOfRows - 1, 0, 0 };
  outputs->GetInformationObject(0)->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  return 1;
}

std::string vtkPDEInfluenceFilter::DescribeFault(int pointsPerCurve) const
{
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

void vtkPDEInfluenceFilter::MakeFace(vtkDataObject* curves, vtkStructuredGrid* grid)
{
  vtkNew<vtkPDEFaceFilter> face;
  const mien::FaceSurfaceOptions& options = this->GetOptions();
  face->SetInputData(curves);
  face->SetScheme(options.scheme);
  for (int patch = 0; patch < mien::FaceLayout::patchCount; ++patch)
    face->SetSmoothing(patch, options.smoothing[patch]);
  face->SetNumberOfModes(options.modes);
  face->SetRemainder(options.remainder);
  face->SetDerivativeStrength(options.derivativeStrength);
  face->SetResolution(this->NumberOfRows, this->NumberOfColumns);
  face->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  face->Update();
  grid->ShallowCopy(face->GetOutput());
}

int vtkPDEInfluenceFilter::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  std::fill(this->Impl->halfWidths, this->Impl->halfWidths + 4, undefined);
  mien::FaceCurves face;
  if (!this->ReadInput(inputs, face))
    return 0;
  const std::string fault = this->DescribeFault(face.curves.pointsPerCurve);
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault);
    return 0;
  }
  const int curve = mien::FaceLayout::curveIndex(this->Curve);
  const mien::RowLayout layout(this->NumberOfRows, false);
  const mien::RowMajor<double> influence =
    mien::surfaceInfluence(this->GetOptions(), face.curves.pointsPerCurve, layout, this->NumberOfColumns, { curve, this->Point });
  const mien::InfluenceProfile profile(influence, layout, curve);
  const double widths[4] = { profile.curvesAbove, profile.curvesBelow, profile.rowsAbove, profile.rowsBelow };
  std::copy(widths, widths + 4, this->Impl->halfWidths);
  vtkStructuredGrid* grid = vtkStructuredGrid::GetData(outputs, 0);
  this->MakeFace(vtkDataObject::GetData(inputs[0]), grid);
  grid->GetPointData()->AddArray(influenceArray(influence, this->Direction));
  fillProfile(profile, vtkTable::GetData(outputs, portOfProfile));
  return 1;
}

void vtkPDEInfluenceFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Curve: " << this->Curve << "\n";
  os << indent << "Point: " << this->Point << "\n";
  os << indent << "Direction: " << this->Direction[0] << " " << this->Direction[1] << " " << this->Direction[2] << "\n";
  os << indent << "NumberOfRows: " << this->NumberOfRows << "\n";
  os << indent << "NumberOfColumns: " << this->NumberOfColumns << "\n";
}
