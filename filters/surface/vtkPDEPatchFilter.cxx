#include "vtkPDEPatchFilter.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "BoundaryCurveData.h"
#include "GridResolution.h"
#include "SurfaceGrid.h"
#include "SurfaceMesh.h"
#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"

vtkStandardNewMacro(vtkPDEPatchFilter);

namespace {

constexpr int minimumRows = 2;
constexpr int largestOrder = 16;
constexpr double largestSmoothing = 1000.0;

std::vector<mien::Condition> evenConditions(int count) {
  std::vector<mien::Condition> conditions;
  for (int i = 0; i < count; ++i) conditions.push_back({count > 1 ? static_cast<double>(i) / (count - 1) : 0.0, 0, i});
  return conditions;
}

/// One sentence when a cell array does not have one number per cell, or nothing; without the array there is no fault.
std::string describeLengthFault(vtkDataArray* array, vtkIdType cells) {
  if (!array || (array->GetNumberOfTuples() == cells && array->GetNumberOfComponents() == 1)) return {};
  return "cell array " + std::string(array->GetName()) + " has " + std::to_string(array->GetNumberOfTuples()) +
         " values of " + std::to_string(array->GetNumberOfComponents()) +
         " components; it needs one number for each of the " + std::to_string(cells) + " lines";
}

/// From the cell arrays U and Derivative, one value per line; no conditions without them.
std::string readConditions(vtkPolyData* curves, std::vector<mien::Condition>& conditions) {
  vtkDataArray* u = curves->GetCellData()->GetArray("U");
  vtkDataArray* derivative = curves->GetCellData()->GetArray("Derivative");
  for (vtkDataArray* array : {u, derivative}) {
    const std::string fault = describeLengthFault(array, curves->GetNumberOfCells());
    if (!fault.empty()) return fault;
  }
  const vtkIdType firstLine = curves->GetNumberOfVerts();
  const int count = static_cast<int>(u ? std::min<vtkIdType>(curves->GetNumberOfLines(), largestOrder) : 0);
  for (int i = 0; i < count; ++i) {
    const double order = derivative ? derivative->GetTuple1(firstLine + i) : 0.0;
    if (!(order >= 0.0 && order < largestOrder && std::floor(order) == order))
      return "array Derivative, curve " + std::to_string(i + 1) + ": " + std::to_string(order) +
             " is no order of a derivative; give a whole number from 0 to one less than there are curves";
    conditions.push_back({u->GetTuple1(firstLine + i), static_cast<int>(order), i});
  }
  return {};
}

std::string describeFault(const std::vector<mien::Condition>& conditions, int curveCount) {
  std::ostringstream fault;
  if (curveCount < 2 || curveCount > largestOrder || curveCount % 2 != 0)
    fault << curveCount << " curves make no patch; an even number from 2 to " << largestOrder << " is needed";
  else if (static_cast<int>(conditions.size()) != curveCount)
    fault << conditions.size() << " conditions for " << curveCount << " curves; each curve needs one";
  else
    for (const mien::Condition& condition : conditions)
      if (!(condition.u >= 0.0 && condition.u <= 1.0) || condition.derivative < 0 ||
          condition.derivative >= curveCount) {
        fault << "the condition of curve " << condition.curve + 1 << " is outside u = 0 .. 1 or derivative = 0 .. "
              << curveCount - 1;
        break;
      }
  return fault.str();
}

std::string describeFault(double a, int modes, int pointsPerCurve) {
  std::ostringstream fault;
  if (!(a > 0.0 && a <= largestSmoothing))
    fault << "a = " << a << " is outside 0 < a <= " << largestSmoothing;
  else if (modes < 0 || modes > pointsPerCurve / 2)
    fault << "N = " << modes << " is outside 0 .. " << pointsPerCurve / 2 << " (curves have " << pointsPerCurve
          << " points)";
  return fault.str();
}

mien::SurfaceGridLayout patchLayout(int rows, int columns) {
  mien::SurfaceGridLayout layout;
  for (int row = 0; row < rows; ++row) layout.faceU.push_back(static_cast<double>(row) / (rows - 1));
  layout.patchOfCells.assign(rows - 1, 0);
  layout.columns = columns;
  return layout;
}

mien::SurfacePiece patchPiece(const std::vector<mien::Condition>& conditions, double a, const std::vector<double>& u) {
  mien::SurfacePiece piece;
  piece.conditions = conditions;
  piece.smoothing = a;
  piece.u = u;
  const int count = static_cast<int>(conditions.size());
  piece.boundaryData = [count](int) { return Eigen::MatrixXd::Identity(count, count).eval(); };
  return piece;
}

}  // namespace

struct vtkPDEPatchFilter::Internals {
  std::vector<mien::Condition> conditions;
};

vtkPDEPatchFilter::vtkPDEPatchFilter() : Impl(new Internals) {}

vtkPDEPatchFilter::~vtkPDEPatchFilter() = default;

void vtkPDEPatchFilter::AddCondition(double u, int derivative) {
  this->Impl->conditions.push_back({u, derivative, this->GetNumberOfConditions()});
  this->Modified();
}

void vtkPDEPatchFilter::ClearConditions() {
  this->Impl->conditions.clear();
  this->Modified();
}

int vtkPDEPatchFilter::GetNumberOfConditions() const {
  return static_cast<int>(this->Impl->conditions.size());
}

void vtkPDEPatchFilter::SetResolution(int rows, int columns) {
  if (rows == this->NumberOfRows && columns == this->NumberOfColumns) return;
  this->NumberOfRows = rows;
  this->NumberOfColumns = columns;
  this->Modified();
}

int vtkPDEPatchFilter::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkPDEPatchFilter::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) {
  const std::string fault = mien::describeResolutionFault(this->NumberOfRows, this->NumberOfColumns, minimumRows);
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return 0;
  }
  mien::offerGrid(outputs->GetInformationObject(0), this->NumberOfRows, this->NumberOfColumns);
  return 1;
}

// Whatever part of the surface is wanted, it takes whole curves.
int vtkPDEPatchFilter::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*) {
  mien::requestWhole(inputs[0]->GetInformationObject(0));
  return 1;
}

int vtkPDEPatchFilter::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  mien::ClosedCurves curves;
  std::string fault = mien::describeResolutionFault(this->NumberOfRows, this->NumberOfColumns, minimumRows);
  if (fault.empty()) fault = mien::readClosedCurves(input, curves);
  std::vector<mien::Condition> conditions = this->Impl->conditions;
  if (conditions.empty() && fault.empty()) fault = readConditions(input, conditions);
  if (conditions.empty()) conditions = evenConditions(curves.count);
  if (fault.empty()) fault = describeFault(conditions, curves.count);
  if (fault.empty()) fault = describeFault(this->Smoothing, this->NumberOfModes, curves.pointsPerCurve);
  if (fault.empty()) {
    mien::SurfaceGridLayout layout = patchLayout(this->NumberOfRows, this->NumberOfColumns);
    outputs->GetInformationObject(0)->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), layout.extent);
    const mien::HarmonicSplit split(curves.pointsPerCurve, this->NumberOfModes, this->Remainder);
    const auto grid = mien::SurfaceGrid::make({patchPiece(conditions, this->Smoothing, layout.faceU)}, split,
                                              curves.count, layout, this->OutputPointsPrecision == DOUBLE_PRECISION);
    fault = grid->fault();
    if (fault.empty()) grid->execute(curves, this->GenerateDerivatives, this, vtkStructuredGrid::GetData(outputs));
  }
  if (!fault.empty()) vtkErrorMacro(<< fault);
  return fault.empty() ? 1 : 0;
}

void vtkPDEPatchFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfConditions: " << this->GetNumberOfConditions() << "\n";
  os << indent << "Smoothing: " << this->Smoothing << "\n";
  os << indent << "NumberOfModes: " << this->NumberOfModes << "\n";
  os << indent << "Remainder: " << this->Remainder << "\n";
  os << indent << "NumberOfRows: " << this->NumberOfRows << "\n";
  os << indent << "NumberOfColumns: " << this->NumberOfColumns << "\n";
  os << indent << "GenerateDerivatives: " << this->GenerateDerivatives << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
