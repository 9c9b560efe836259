#include "vtkFDTDeformationFilter.h"

#include "DefaultRegions.h"
#include "FDTData.h"
#include "TableDeformation.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkTable.h"

#include <array>
#include <cmath>
#include <optional>

vtkStandardNewMacro(vtkFDTDeformationFilter);

namespace {

constexpr vtkIdType pointsPerTask = 4096;

/// An array by its name, if it is there with these components.
vtkDataArray* pointArray(vtkPointSet* data, const char* name, int components) {
  vtkDataArray* array = data->GetPointData()->GetArray(name);
  return array && array->GetNumberOfComponents() == components ? array : nullptr;
}

/// @return nothing, or one sentence that names the first point that is not finite
std::string readPoints(vtkPointSet* data, std::vector<mien::DeformationPoint>& points) {
  vtkDataArray* normals = pointArray(data, "Normals", 3);
  vtkDataArray* sides = pointArray(data, "LipSide", 1);
  points.resize(data->GetNumberOfPoints());
  for (std::size_t i = 0; i < points.size(); ++i) {
    mien::DeformationPoint& point = points[i];
    data->GetPoint(i, point.position.data());
    if (normals) point.normalZ = normals->GetComponent(i, 2);
    if (sides) point.side.lips = sides->GetComponent(i, 0);
    if (!point.position.allFinite() || !std::isfinite(point.normalZ) || !std::isfinite(point.side.lips))
      return "point " + std::to_string(i) + " has a position, normal or lip side that is not finite; repair the mesh";
  }
  return {};
}

}  // namespace

struct vtkFDTDeformationFilter::Internals {
  std::optional<mien::TableDeformation> weights;
  vtkMTimeType inputTime = 0;
  vtkPointSet* input = nullptr;
  std::array<double, 6> pupils{};
  bool smooth = false;

  /// Computes the weights unless those of before still hold. @return nothing, or what is wrong
  std::string prepare(vtkPointSet* data, const double* left, const double* right, bool blend) {
    const std::array<double, 6> now = {left[0], left[1], left[2], right[0], right[1], right[2]};
    if (weights && data == input && data->GetMTime() == inputTime && now == pupils && blend == smooth) return {};
    weights.reset();
    mien::PupilNormalisation normalisation;
    std::string fault = normalisation.set(Eigen::Map<const Eigen::Vector3d>(left), Eigen::Map<const Eigen::Vector3d>(right));
    std::vector<mien::DeformationPoint> points;
    if (fault.empty()) fault = readPoints(data, points);
    if (!fault.empty()) return fault;
    weights.emplace(points, normalisation, mien::defaultRegions(), blend);
    input = data;
    inputTime = data->GetMTime();
    pupils = now;
    smooth = blend;
    return {};
  }

  void move(vtkPointSet* from, vtkPointSet* to, const mien::DeformationTable& table, double strength) const {
    const vtkIdType count = from->GetNumberOfPoints();
    vtkNew<vtkDoubleArray> displacement;
    displacement->SetName("Displacement");
    displacement->SetNumberOfComponents(3);
    displacement->SetNumberOfTuples(count);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(count);
    const double limit = mien::fittedDisplacement(table, mien::defaultRegions());
    vtkSMPTools::For(0, count, pointsPerTask, [&](vtkIdType begin, vtkIdType end) {
      std::vector<Eigen::Vector2d> moves(end - begin);
      weights->displacements(table, limit, strength, begin, end, moves.data());
      double place[3];
      for (vtkIdType i = begin; i < end; ++i) {
        const Eigen::Vector2d& d = moves[i - begin];
        from->GetPoint(i, place);
        points->SetPoint(i, place[0] + d.x(), place[1] + d.y(), place[2]);
        displacement->SetTuple3(i, d.x(), d.y(), 0.0);
      }
    });
    to->ShallowCopy(from);
    to->SetPoints(points);
    to->GetPointData()->RemoveArray("Normals");
    to->GetPointData()->AddArray(displacement);
  }
};

vtkFDTDeformationFilter::vtkFDTDeformationFilter() : Impl(new Internals) {
  this->SetNumberOfInputPorts(3);
}

vtkFDTDeformationFilter::~vtkFDTDeformationFilter() = default;

int vtkFDTDeformationFilter::FillInputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPointSet" : "vtkTable");
  if (port == 2) info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkFDTDeformationFilter::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) {
  mien::DeformationTable table, other;
  vtkTable* second = vtkTable::GetData(inputs[2]);
  std::string fault = mien::readFDT(vtkTable::GetData(inputs[1]), table);
  if (fault.empty() && second) fault = mien::readFDT(second, other);
  vtkPointSet* input = vtkPointSet::GetData(inputs[0]);
  if (fault.empty()) fault = this->Impl->prepare(input, this->LeftPupil, this->RightPupil, this->Smooth);
  if (fault.empty() && !std::isfinite(this->Strength)) fault = "the strength is not finite; give 0 to 1.5";
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return 0;
  }
  if (second) table = table.blended(other, this->Interpolation);
  this->Impl->move(input, vtkPointSet::GetData(outputs), table, this->Strength);
  return 1;
}

void vtkFDTDeformationFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LeftPupil: " << this->LeftPupil[0] << " " << this->LeftPupil[1] << " " << this->LeftPupil[2] << "\n";
  os << indent << "RightPupil: " << this->RightPupil[0] << " " << this->RightPupil[1] << " " << this->RightPupil[2] << "\n";
  os << indent << "Strength: " << this->Strength << "\n";
  os << indent << "Interpolation: " << this->Interpolation << "\n";
  os << indent << "Smooth: " << (this->Smooth ? "on" : "off") << "\n";
}
