#include "vtkMotionVectorFilter.h"

#include <Eigen/Geometry>
#include <cmath>

#include "RigidMotion.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkMotionVectorFilter);

/// The vectors and the plane of the picture.
struct vtkMotionVectorFilter::Field {
  mien::ClosedCurves::Points Origins, Vectors;
  Eigen::Vector3d Right, Up;
};

namespace {

using Points = mien::ClosedCurves::Points;

Points readPoints(vtkPointSet* data) {
  Points points(data->GetNumberOfPoints(), 3);
  for (vtkIdType i = 0; i < points.rows(); ++i) data->GetPoint(i, points.row(i).data());
  return points;
}

std::string describeTopologyFault(vtkPointSet* moved, vtkPointSet* neutral) {
  const std::string advice = "; motion vectors need two states of one surface";
  const vtkIdType points = moved->GetNumberOfPoints(), cells = moved->GetNumberOfCells();
  if (points != neutral->GetNumberOfPoints())
    return "the moved surface has " + std::to_string(points) + " points and the neutral one " +
           std::to_string(neutral->GetNumberOfPoints()) + advice;
  if (cells != neutral->GetNumberOfCells())
    return "the moved surface has " + std::to_string(cells) + " cells and the neutral one " +
           std::to_string(neutral->GetNumberOfCells()) + advice;
  vtkNew<vtkIdList> ours, theirs;
  for (vtkIdType cell = 0; cell < cells; ++cell) {
    moved->GetCellPoints(cell, ours);
    neutral->GetCellPoints(cell, theirs);
    if (std::vector<vtkIdType>(ours->begin(), ours->end()) != std::vector<vtkIdType>(theirs->begin(), theirs->end()))
      return "cell " + std::to_string(cell) + " joins other points in the moved surface than in the neutral one" + advice;
  }
  return {};
}

std::string describeInputFault(vtkPointSet* moved, vtkPointSet* neutral) {
  if (!moved || moved->GetNumberOfPoints() == 0) return "there are no points on port 0; connect the moved surface";
  if (!neutral || neutral->GetNumberOfPoints() == 0) return "there are no points on port 1; connect the neutral surface";
  return describeTopologyFault(moved, neutral);
}

vtkDoubleArray* addArray(vtkPolyData* output, const char* name, int components) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(output->GetNumberOfPoints());
  output->GetPointData()->AddArray(array);
  return array;
}

void addVertices(vtkPolyData* output) {
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i) vertices->InsertNextCell(1, &i);
  output->SetVerts(vertices);
}

}  // namespace

vtkMotionVectorFilter::vtkMotionVectorFilter() {
  this->SetNumberOfInputPorts(2);
}

int vtkMotionVectorFilter::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

std::string vtkMotionVectorFilter::Compute(vtkPointSet* moved, vtkPointSet* neutral, Field& field) {
  const Eigen::Vector3d direction = Eigen::Vector3d(this->ViewDirection).normalized();
  field.Right = Eigen::Vector3d(this->ViewUp).cross(direction);
  if (!(direction.norm() > 0.5) || !(field.Right.norm() > 1e-9 * Eigen::Vector3d(this->ViewUp).norm()))
    return "the view direction is 0 or the view up lies along it; give two different directions";
  field.Right.normalize();
  field.Up = direction.cross(field.Right);
  field.Origins = readPoints(neutral);
  Points target = readPoints(moved);
  if (!field.Origins.allFinite() || !target.allFinite()) return "a surface has points that are not finite; repair it";
  mien::RigidMotion motion;
  if (this->RemoveRigidMotion) {
    motion = mien::fitRigidMotion(field.Origins, target);
    target = motion.undone(target);
  }
  this->RigidAngle = motion.angle() * 180.0 / M_PI;
  const Eigen::Matrix3d rows = motion.rotation.transpose();  // stored by columns: transposed, row by row
  this->RigidRotation.assign(rows.data(), rows.data() + 9);
  this->RigidTranslation.assign(motion.translation.data(), motion.translation.data() + 3);
  field.Vectors = target - field.Origins;
  this->LargestMagnitude = field.Vectors.rowwise().norm().maxCoeff();
  return {};
}

void vtkMotionVectorFilter::Write(vtkPointSet* neutral, const Field& field, vtkPolyData* output) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(neutral->GetPoints());
  output->SetPoints(points);
  output->GetPointData()->ShallowCopy(neutral->GetPointData());
  addVertices(output);
  vtkDoubleArray* vectors = addArray(output, "MotionVector", 3);
  vtkDoubleArray* magnitudes = addArray(output, "Magnitude", 1);
  vtkDoubleArray* origins = addArray(output, "ProjectedOrigin", 2);
  vtkDoubleArray* projected = addArray(output, "ProjectedVector", 2);
  for (vtkIdType i = 0; i < field.Vectors.rows(); ++i) {
    const Eigen::Vector3d origin = field.Origins.row(i), vector = field.Vectors.row(i);
    vectors->SetTypedTuple(i, vector.data());
    magnitudes->SetValue(i, vector.norm());
    origins->SetTuple2(i, origin.dot(field.Right), origin.dot(field.Up));
    projected->SetTuple2(i, vector.dot(field.Right), vector.dot(field.Up));
  }
  output->GetPointData()->SetActiveVectors("MotionVector");
  output->GetPointData()->SetActiveScalars("Magnitude");
}

int vtkMotionVectorFilter::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) {
  vtkPointSet* moved = vtkPointSet::GetData(inputs[0]);
  vtkPointSet* neutral = vtkPointSet::GetData(inputs[1]);
  Field field;
  std::string fault = describeInputFault(moved, neutral);
  if (fault.empty()) fault = this->Compute(moved, neutral, field);
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return 0;
  }
  if (this->GetAbortExecute()) return 1;
  this->Write(neutral, field, vtkPolyData::GetData(outputs));
  return 1;
}

void vtkMotionVectorFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RemoveRigidMotion: " << this->RemoveRigidMotion << "\n";
  os << indent << "ViewDirection: " << this->ViewDirection[0] << " " << this->ViewDirection[1] << " "
     << this->ViewDirection[2] << "\n";
  os << indent << "ViewUp: " << this->ViewUp[0] << " " << this->ViewUp[1] << " " << this->ViewUp[2] << "\n";
  os << indent << "LargestMagnitude: " << this->LargestMagnitude << " mm\n";
  os << indent << "RigidAngle: " << this->RigidAngle << " degrees\n";
}
