#include "vtkPupilNormalizeFilter.h"

#include <atomic>

#include "BoundaryCurveData.h"
#include "FaceFrame.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"

vtkStandardNewMacro(vtkPupilNormalizeFilter);

namespace {

constexpr vtkIdType normalisedPerSlab = 1 << 20, normalisedPerTask = 4096;

void writePupils(vtkPointSet* data, const char* name, const mien::EyePupils& pupils) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->InsertNextTuple(pupils.left.data());
  array->InsertNextTuple(pupils.right.data());
  data->GetFieldData()->AddArray(array);
}

/// The frame to go back to. @return nothing, or what is missing
std::string readOriginalPupils(vtkPointSet* data, const mien::FaceFrameOptions& options, mien::FaceFrame& frame) {
  frame.places = {options.leftPupil, options.rightPupil};
  if (options.leftPupil == options.rightPupil) {
    vtkDataArray* array = data->GetFieldData()->GetArray("OriginalPupils");
    if (!array || array->GetNumberOfTuples() != 2 || array->GetNumberOfComponents() != 3)
      return "there are no pupils to go back to; set both, or give data of this filter with the field array "
             "OriginalPupils (2 x 3)";
    array->GetTuple(0, frame.places.left.data());
    array->GetTuple(1, frame.places.right.data());
  }
  return frame.pupils.set(frame.places.left, frame.places.right);
}

using Change = Eigen::Vector3d (mien::PupilNormalisation::*)(const Eigen::Vector3d&) const;

/// @return a point that is not finite, -1 for none
vtkIdType changePoints(vtkPointSet* from, const mien::PupilNormalisation& pupils, Change change, vtkAlgorithm* self,
                       vtkPoints* to) {
  std::atomic<vtkIdType> fault{-1};
  const vtkIdType count = from->GetNumberOfPoints();
  to->SetDataTypeToDouble();
  to->SetNumberOfPoints(count);
  for (vtkIdType slab = 0; slab < count && !self->GetAbortExecute(); slab += normalisedPerSlab) {
    const vtkIdType slabEnd = std::min(count, slab + normalisedPerSlab);
    vtkSMPTools::For(slab, slabEnd, normalisedPerTask, [&](vtkIdType begin, vtkIdType end) {
      Eigen::Vector3d point;
      for (vtkIdType i = begin; i < end; ++i) {
        from->GetPoint(i, point.data());
        if (!point.allFinite()) fault = i;
        to->SetPoint(i, (pupils.*change)(point).eval().data());
      }
    });
    self->UpdateProgress(double(slabEnd) / count);
  }
  return fault;
}

void turnNormals(vtkPointSet* data, const mien::PupilNormalisation& pupils, Change change) {
  vtkDataArray* normals = data->GetPointData()->GetNormals();
  if (!normals) return;
  vtkSmartPointer<vtkDataArray> turned;
  turned.TakeReference(normals->NewInstance());
  turned->DeepCopy(normals);
  const Eigen::Vector3d origin = (pupils.*change)(Eigen::Vector3d::Zero());
  for (vtkIdType i = 0; i < turned->GetNumberOfTuples(); ++i) {
    Eigen::Vector3d normal;
    turned->GetTuple(i, normal.data());
    turned->SetTuple(i, ((pupils.*change)(normal)-origin).normalized().eval().data());
  }
  data->GetPointData()->SetNormals(turned);
}

/// The turn of the head as it is in the other frame: the same about the same place, seen from there.
void changeRotation(vtkPointSet* data, const mien::HeadRotation& turned, const mien::PupilNormalisation& pupils,
                    Change change) {
  if (!data->GetFieldData()->HasArray("HeadRotation")) return;
  const Eigen::Vector3d origin = (pupils.*change)(Eigen::Vector3d::Zero());
  Eigen::Matrix3d axes;
  for (int k = 0; k < 3; ++k) axes.col(k) = ((pupils.*change)(Eigen::Vector3d::Unit(k)) - origin).normalized();
  mien::HeadRotation changed;
  changed.rotation = axes * turned.rotation * axes.transpose();
  changed.centre = (pupils.*change)(turned.centre);
  mien::writeHeadRotation(changed, data->GetFieldData());
}

}  // namespace

int vtkPupilNormalizeFilter::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                         vtkInformationVector* outputs) {
  vtkPointSet *input = vtkPointSet::GetData(inputs[0]), *output = vtkPointSet::GetData(outputs);
  if (input->GetNumberOfPoints() == 0) return 1;
  mien::FaceFrame frame;
  const mien::FaceFrameOptions options = this->GetFrameOptions();
  std::string fault =
      this->Inverse ? readOriginalPupils(input, options, frame) : mien::readPupils(input, options, frame);
  // In space, not in the frame of a turned head: what is normalised is where the pupils are seen.
  if (fault.empty()) fault = frame.pupils.set(frame.places.left, frame.places.right);
  vtkNew<vtkPoints> points;
  const Change change = this->Inverse ? &mien::PupilNormalisation::invert : &mien::PupilNormalisation::apply;
  const vtkIdType broken = fault.empty() ? changePoints(input, frame.pupils, change, this, points) : -1;
  if (broken >= 0) fault = "point " + std::to_string(broken) + " is not finite; repair or remove it";
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return 0;
  }
  if (this->GetAbortExecute()) return 1;
  mien::HeadRotation turned;
  fault = mien::readHeadRotation(input->GetFieldData(), turned);
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return 0;
  }
  output->ShallowCopy(input);
  output->SetPoints(points);
  turnNormals(output, frame.pupils, change);
  changeRotation(output, turned, frame.pupils, change);
  output->GetFieldData()->RemoveArray("OriginalPupils");
  if (this->Inverse) {
    writePupils(output, "Pupils", frame.places);
  } else {
    writePupils(output, "Pupils", {frame.pupils.apply(frame.places.left), frame.pupils.apply(frame.places.right)});
    writePupils(output, "OriginalPupils", frame.places);
  }
  KeepWantedPart(outputs->GetInformationObject(0));
  return 1;
}

void vtkPupilNormalizeFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Inverse: " << (this->Inverse ? "on" : "off") << "\n";
}
