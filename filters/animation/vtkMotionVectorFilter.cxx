#include "vtkMotionVectorFilter.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "BoundaryCurveData.h"
#include "PicturePlane.h"
#include "RigidMotion.h"
#include "SurfaceMesh.h"
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
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"

vtkStandardNewMacro(vtkMotionVectorFilter);

/// The vectors and the plane of the picture.
struct vtkMotionVectorFilter::Field {
  mien::ClosedCurves::Points Origins, Vectors;
  mien::PicturePlane Plane;
};

namespace {

using Points = mien::ClosedCurves::Points;
using SDDP = vtkStreamingDemandDrivenPipeline;

constexpr vtkIdType pointsPerLook = 1 << 16;  // between two looks at the abort flag

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
      return "cell " + std::to_string(cell) + " joins other points in the moved surface than in the neutral one" +
             advice;
  }
  return {};
}

std::string describeInputFault(vtkPointSet* moved, vtkPointSet* neutral) {
  if (!moved || moved->GetNumberOfPoints() == 0) return "there are no points on port 0; connect the moved surface";
  if (!neutral || neutral->GetNumberOfPoints() == 0)
    return "there are no points on port 1; connect the neutral surface";
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

/// Neighbouring pieces of a grid share the points of their border: only the lower piece gives them a vertex.
bool belongsToLowerPiece(const int* extent, const int* whole, vtkIdType point) {
  const vtkIdType columns = extent[1] - extent[0] + 1, rows = extent[3] - extent[2] + 1;
  const vtkIdType place[3] = {point % columns, point / columns % rows, point / columns / rows};
  for (int axis = 0; axis < 3; ++axis)
    if (place[axis] == 0 && extent[2 * axis] > whole[2 * axis]) return true;
  return false;
}

void addVertices(vtkPointSet* origin, vtkInformation* input, vtkPolyData* output) {
  auto* grid = vtkStructuredGrid::SafeDownCast(origin);
  const int* whole = grid && input->Has(SDDP::WHOLE_EXTENT()) ? input->Get(SDDP::WHOLE_EXTENT()) : nullptr;
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    if (!whole || !belongsToLowerPiece(grid->GetExtent(), whole, i)) vertices->InsertNextCell(1, &i);
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

namespace {

/// Adds the time steps of one input.
void collectSteps(vtkInformation* input, std::vector<double>& steps) {
  if (!input || !input->Has(SDDP::TIME_STEPS())) return;
  const double* first = input->Get(SDDP::TIME_STEPS());
  steps.insert(steps.end(), first, first + input->Length(SDDP::TIME_STEPS()));
}

/// Turns points back by the head's rotation that their data carry.
std::string undoHeadRotation(vtkPointSet* data, Points& points) {
  mien::HeadRotation rotation;
  const std::string fault = mien::readHeadRotation(data->GetFieldData(), rotation);
  if (fault.empty()) rotation.undo(points);
  return fault;
}

/// Normals that VTK has passed from the neutral surface turn back with it.
void undoHeadRotationOfNormals(vtkPointSet* neutral, vtkPolyData* output) {
  vtkDataArray* normals = neutral->GetPointData()->GetArray("Normals");
  mien::HeadRotation rotation;
  const std::string fault = mien::readHeadRotation(neutral->GetFieldData(), rotation);
  if (!fault.empty() || !rotation.turns() || !normals || normals->GetNumberOfComponents() != 3) return;
  vtkNew<vtkDoubleArray> turned;
  turned->DeepCopy(normals);
  for (vtkIdType i = 0; i < turned->GetNumberOfTuples(); ++i) {
    Eigen::RowVector3d normal;
    normals->GetTuple(i, normal.data());
    normal = normal * rotation.rotation;  // the inverse, on a row
    turned->SetTypedTuple(i, normal.data());
  }
  output->GetPointData()->SetNormals(turned);
}

/// An empty piece of inputs that are cut into pieces is no fault.
bool isEmptyPiece(vtkPointSet* moved, vtkPointSet* neutral, vtkInformation* output) {
  const bool empty = moved && neutral && moved->GetNumberOfPoints() == 0 && neutral->GetNumberOfPoints() == 0;
  return empty && output->Get(SDDP::UPDATE_NUMBER_OF_PIECES()) > 1;
}

void copyDataTime(vtkDataObject* moved, vtkDataObject* neutral, vtkDataObject* output) {
  for (vtkDataObject* from : {neutral, moved})
    if (from->GetInformation()->Has(vtkDataObject::DATA_TIME_STEP()))
      output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(),
                                    from->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()));
}

}  // namespace

/// VTK forwards time from the first port only.
int vtkMotionVectorFilter::RequestInformation(vtkInformation*, vtkInformationVector** inputs,
                                              vtkInformationVector* outputs) {
  std::vector<double> steps;
  for (int port = 0; port < 2; ++port) collectSteps(inputs[port]->GetInformationObject(0), steps);
  vtkInformation* out = outputs->GetInformationObject(0);
  out->Remove(SDDP::TIME_STEPS());
  out->Remove(SDDP::TIME_RANGE());
  out->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
  if (steps.empty()) return 1;
  std::sort(steps.begin(), steps.end());
  steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
  const double range[2] = {steps.front(), steps.back()};
  out->Set(SDDP::TIME_STEPS(), steps.data(), static_cast<int>(steps.size()));
  out->Set(SDDP::TIME_RANGE(), range, 2);
  return 1;
}

int vtkMotionVectorFilter::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs,
                                               vtkInformationVector* outputs) {
  vtkInformation* out = outputs->GetInformationObject(0);
  for (int port = 0; port < 2; ++port) {
    vtkInformation* input = inputs[port]->GetInformationObject(0);
    if (!input) continue;
    if (out->Has(SDDP::UPDATE_TIME_STEP())) input->Set(SDDP::UPDATE_TIME_STEP(), out->Get(SDDP::UPDATE_TIME_STEP()));
    if (this->RemoveRigidMotion) mien::requestWhole(input);
  }
  return 1;
}

std::string vtkMotionVectorFilter::Compute(vtkPointSet* moved, vtkPointSet* neutral, Field& field) {
  std::string fault = field.Plane.look(Eigen::Vector3d(this->ViewDirection), Eigen::Vector3d(this->ViewUp));
  if (!fault.empty()) return fault;
  field.Origins = readPoints(neutral);
  Points target = readPoints(moved);
  if (!field.Origins.allFinite() || !target.allFinite()) return "a surface has points that are not finite; repair it";
  if (this->RemoveHeadRotation) {
    fault = undoHeadRotation(neutral, field.Origins);
    if (fault.empty()) fault = undoHeadRotation(moved, target);
    if (!fault.empty()) return fault;
  }
  mien::RigidMotion motion;
  if (this->RemoveRigidMotion) {
    motion = mien::fitStillPart(field.Origins, target);
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

/// False when it was aborted.
bool vtkMotionVectorFilter::Write(vtkPointSet* neutral, const Field& field, vtkPolyData* output) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(field.Origins.rows());
  output->SetPoints(points);
  output->GetPointData()->ShallowCopy(neutral->GetPointData());
  if (this->RemoveHeadRotation) undoHeadRotationOfNormals(neutral, output);
  addVertices(neutral, this->GetInputInformation(1, 0), output);
  vtkDoubleArray* vectors = addArray(output, "MotionVector", 3);
  vtkDoubleArray* magnitudes = addArray(output, "Magnitude", 1);
  vtkDoubleArray* origins = addArray(output, "ProjectedOrigin", 2);
  vtkDoubleArray* projected = addArray(output, "ProjectedVector", 2);
  for (vtkIdType i = 0; i < field.Vectors.rows(); ++i) {
    if (i % pointsPerLook == 0) {
      this->UpdateProgress(static_cast<double>(i) / field.Vectors.rows());
      if (this->GetAbortExecute()) return false;
    }
    const Eigen::Vector3d origin = field.Origins.row(i), vector = field.Vectors.row(i);
    points->SetPoint(i, origin.data());
    vectors->SetTypedTuple(i, vector.data());
    magnitudes->SetValue(i, vector.norm());
    origins->SetTypedTuple(i, field.Plane.project(origin).data());
    projected->SetTypedTuple(i, field.Plane.project(vector).data());
  }
  output->GetPointData()->SetActiveVectors("MotionVector");
  output->GetPointData()->SetActiveScalars("Magnitude");
  return true;
}

int vtkMotionVectorFilter::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) {
  vtkPointSet* moved = vtkPointSet::GetData(inputs[0]);
  vtkPointSet* neutral = vtkPointSet::GetData(inputs[1]);
  vtkInformation* out = outputs->GetInformationObject(0);
  const bool leftToFirstPiece = this->RemoveRigidMotion && out->Get(SDDP::UPDATE_PIECE_NUMBER()) > 0;
  if (leftToFirstPiece || isEmptyPiece(moved, neutral, out)) return 1;
  Field field;
  std::string fault = describeInputFault(moved, neutral);
  if (fault.empty()) fault = this->Compute(moved, neutral, field);
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return 0;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (this->GetAbortExecute() || !this->Write(neutral, field, output))
    output->Initialize();
  else
    copyDataTime(moved, neutral, output);
  return 1;
}

void vtkMotionVectorFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RemoveRigidMotion: " << this->RemoveRigidMotion << "\n";
  os << indent << "RemoveHeadRotation: " << this->RemoveHeadRotation << "\n";
  os << indent << "ViewDirection: " << this->ViewDirection[0] << " " << this->ViewDirection[1] << " "
     << this->ViewDirection[2] << "\n";
  os << indent << "ViewUp: " << this->ViewUp[0] << " " << this->ViewUp[1] << " " << this->ViewUp[2] << "\n";
  os << indent << "LargestMagnitude: " << this->LargestMagnitude << " mm\n";
  os << indent << "RigidAngle: " << this->RigidAngle << " degrees\n";
}
