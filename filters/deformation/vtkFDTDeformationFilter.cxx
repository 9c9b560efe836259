#include "vtkFDTDeformationFilter.h"

#include <cmath>
#include <optional>

#include "FDTData.h"
#include "FaceFrame.h"
#include "MeshEdgeData.h"
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

vtkStandardNewMacro(vtkFDTDeformationFilter);

namespace {

constexpr vtkIdType pointsPerSlab = 1 << 18, pointsPerTask = 4096;

bool sameFrame(const mien::FaceFrameOptions& a, const mien::FaceFrameOptions& b) {
  return a.leftPupil == b.leftPupil && a.rightPupil == b.rightPupil && a.leftPupilName == b.leftPupilName &&
         a.rightPupilName == b.rightPupilName && a.landmarkFile == b.landmarkFile;
}

/// What a surface says of itself that the moved points make untrue.
void dropDerivatives(vtkPointSet* data) {
  for (const char* name : {"Su", "Sv", "MeanCurvature", "GaussianCurvature", "MaximumCurvature", "MinimumCurvature"})
    data->GetPointData()->RemoveArray(name);
}

}  // namespace

struct vtkFDTDeformationFilter::Internals {
  mien::FacialRegions regions;
  mien::FaceFrameOptions options;
  std::string regionFile;
  std::optional<mien::TableDeformation> weights;
  mien::MeshPolygons polygons;
  std::vector<Eigen::Vector3d> before;  ///< normals of the polygons, where the input has normals to be turned
  Eigen::Matrix3d toSpace;
  vtkPointSet* input = nullptr;
  vtkMTimeType inputTime = 0;
  bool smooth = false;
  std::string warning;

  bool holdsFor(vtkPointSet* data, const mien::FaceFrameOptions& now, const std::string& file, bool blend) const {
    return weights && data == input && data->GetMTime() == inputTime && sameFrame(now, options) && file == regionFile &&
           blend == smooth;
  }

  /// Computes the weights unless those of before still hold. @return nothing, or what is wrong
  std::string prepare(vtkPointSet* data, const mien::FaceFrameOptions& now, const std::string& file, bool blend,
                      const mien::Progress& progress) {
    if (holdsFor(data, now, file, blend)) return {};
    weights.reset();
    mien::FaceFrame frame;
    std::string fault = mien::readRegions(file, regions);
    if (fault.empty()) fault = mien::readFaceFrame(data, now, regions, frame, mien::partOf(progress, 0.0, 0.6));
    if (fault.empty()) readPolygons(data);
    if (fault.empty() && !mien::goesOn(progress, 0.7)) fault = "stopped before the weights were known";
    if (!fault.empty()) return fault;
    warning = frame.warning;
    weights.emplace(frame.points, frame.pupils, regions, blend, mien::partOf(progress, 0.7, 1.0));
    if (weights->size() < frame.points.size()) {
      weights.reset();
      return "stopped before the weights were known";
    }
    toSpace = frame.turned.rotation;
    input = data;
    inputTime = data->GetMTime();
    options = now;
    regionFile = file;
    smooth = blend;
    return {};
  }

  void readPolygons(vtkPointSet* data) {
    polygons = normalsOf(data) ? mien::MeshPolygons(data) : mien::MeshPolygons();
    before = polygons.normals(data->GetPoints());
  }

  static vtkDataArray* normalsOf(vtkPointSet* data) {
    vtkDataArray* normals = data->GetPointData()->GetArray("Normals");
    return normals && normals->GetNumberOfComponents() == 3 ? normals : nullptr;
  }

  /// Turns the input's normals by as much as those of the polygons around each point turn; without polygons they stay.
  void turnNormals(vtkPointSet* from, vtkPointSet* to) const {
    vtkDataArray* normals = normalsOf(from);
    if (!normals || polygons.empty()) return;
    const std::vector<Eigen::Vector3d> after = polygons.normals(to->GetPoints());
    vtkSmartPointer<vtkDataArray> turned;
    turned.TakeReference(normals->NewInstance());
    turned->DeepCopy(normals);
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (after[i] == before[i]) continue;  // bit for bit as it was
      Eigen::Vector3d normal;
      normals->GetTuple(i, normal.data());
      // Polygons may be wound inwards, as those of the PDE face are.
      const double sign = before[i].dot(normal) < 0.0 ? -1.0 : 1.0;
      turned->SetTuple(i, (normal + sign * (after[i] - before[i])).stableNormalized().eval().data());
    }
    to->GetPointData()->SetNormals(turned);
  }

  /// False when aborted.
  bool move(vtkPointSet* from, const mien::DeformationTable& table, double strength, vtkAlgorithm* self,
            vtkPoints* points, vtkDoubleArray* displacement) const {
    const double limit = mien::fittedDisplacement(table, regions);
    const vtkIdType count = from->GetNumberOfPoints();
    for (vtkIdType slab = 0; slab < count; slab += pointsPerSlab) {
      if (self->GetAbortExecute()) return false;
      const vtkIdType slabEnd = std::min(count, slab + pointsPerSlab);
      vtkSMPTools::For(slab, slabEnd, pointsPerTask, [&](vtkIdType begin, vtkIdType end) {
        std::vector<Eigen::Vector2d> moves(end - begin);
        weights->displacements(table, limit, strength, begin, end, moves.data());
        Eigen::Vector3d place;
        for (vtkIdType i = begin; i < end; ++i) {
          const Eigen::Vector3d d = toSpace.leftCols<2>() * moves[i - begin];
          from->GetPoint(i, place.data());
          displacement->SetTypedTuple(i, d.data());
          points->SetPoint(i, (place + d).eval().data());
        }
      });
      self->UpdateProgress(0.5 + 0.5 * slabEnd / count);
    }
    return !self->GetAbortExecute();
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

int vtkFDTDeformationFilter::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                         vtkInformationVector* outputs) {
  vtkPointSet *input = vtkPointSet::GetData(inputs[0]), *output = vtkPointSet::GetData(outputs);
  mien::DeformationTable table, other;
  vtkTable* second = vtkTable::GetData(inputs[2]);
  std::string fault = mien::readFDT(vtkTable::GetData(inputs[1]), table);
  if (fault.empty() && second) fault = "second " + mien::readFDT(second, other);
  if (fault == "second ") fault.clear();
  if (fault.empty() && !std::isfinite(this->Strength)) fault = "the strength is not finite; give 0 to 1.5";
  if (fault.empty() && input->GetNumberOfPoints() > 0)
    fault = this->Impl->prepare(input, this->GetFrameOptions(), this->GetRegionFileName(), this->Smooth,
                                this->ReportProgress(0.0, 0.5));
  if (this->GetAbortExecute()) return 1;
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return 0;
  }
  if (input->GetNumberOfPoints() == 0) return 1;
  if (!this->Impl->warning.empty()) vtkWarningMacro(<< this->Impl->warning);
  if (second) table = table.blended(other, this->Interpolation);
  vtkNew<vtkDoubleArray> displacement;
  displacement->SetName("Displacement");
  displacement->SetNumberOfComponents(3);
  displacement->SetNumberOfTuples(input->GetNumberOfPoints());
  vtkNew<vtkPoints> points;
  points->SetDataType(input->GetPoints()->GetDataType());
  points->SetNumberOfPoints(input->GetNumberOfPoints());
  if (!this->Impl->move(input, table, this->Strength, this, points, displacement)) return 1;
  output->ShallowCopy(input);
  output->SetPoints(points);
  output->GetPointData()->AddArray(displacement);
  this->Impl->turnNormals(input, output);
  dropDerivatives(output);
  KeepWantedPart(outputs->GetInformationObject(0));
  return 1;
}

void vtkFDTDeformationFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Strength: " << this->Strength << "\n";
  os << indent << "Interpolation: " << this->Interpolation << "\n";
  os << indent << "Smooth: " << (this->Smooth ? "on" : "off") << "\n";
}
