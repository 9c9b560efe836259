#include "vtkFacialRegionFilter.h"

#include "FaceFrame.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkSMPTools.h"
#include "vtkStringArray.h"

vtkStandardNewMacro(vtkFacialRegionFilter);

namespace {

constexpr vtkIdType classifiedPerSlab = 1 << 18, classifiedPerTask = 1024;

/// The arrays that the filter adds.
struct Arrays {
  vtkNew<vtkIntArray> region;
  vtkNew<vtkFloatArray> weights, coverage, lips, lids;

  explicit Arrays(vtkIdType points) {
    region->SetName("Region");
    weights->SetName("RegionWeights");
    weights->SetNumberOfComponents(mien::FacialRegions::count);
    coverage->SetName("RegionCoverage");
    lips->SetName("LipSide");
    lids->SetName("LidSide");
    for (vtkDataArray* array : this->all()) array->SetNumberOfTuples(points);
  }

  std::array<vtkDataArray*, 5> all() { return {region, weights, coverage, lips, lids}; }

  void fill(vtkIdType i, const mien::FaceFrame& frame, const mien::FacialRegions& regions) {
    const mien::DeformationPoint& point = frame.points[i];
    const Eigen::Vector3d place = frame.pupils.apply(point.position);
    region->SetValue(i, point.region ? point.region : regions.nearest(place.head<2>(), point.side));
    mien::FacialRegions::Weights all = regions.weights(place.head<2>(), point.side);
    if (point.region) {
      all.fill(0.0);
      all[point.region - 1] = 1.0;
    }
    for (int k = 0; k < mien::FacialRegions::count; ++k) weights->SetTypedComponent(i, k, static_cast<float>(all[k]));
    coverage->SetValue(i, static_cast<float>(mien::coverageOf(regions, place, point)));
    lips->SetValue(i, static_cast<float>(point.side.lips));
    lids->SetValue(i, static_cast<float>(point.side.lids));
  }
};

}  // namespace

int vtkFacialRegionFilter::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) {
  vtkPointSet *input = vtkPointSet::GetData(inputs[0]), *output = vtkPointSet::GetData(outputs);
  if (input->GetNumberOfPoints() == 0) return 1;
  mien::FacialRegions regions;
  mien::FaceFrame frame;
  std::string fault = mien::readRegions(this->GetRegionFileName(), regions);
  if (fault.empty())
    fault = mien::readFaceFrame(input, this->GetFrameOptions(), regions, frame, this->ReportProgress(0.0, 0.5));
  if (this->GetAbortExecute()) return 1;
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return 0;
  }
  if (!frame.warning.empty()) vtkWarningMacro(<< frame.warning);
  const vtkIdType count = input->GetNumberOfPoints();
  Arrays arrays(count);
  for (vtkIdType slab = 0; slab < count; slab += classifiedPerSlab) {
    if (this->GetAbortExecute()) return 1;
    const vtkIdType slabEnd = std::min(count, slab + classifiedPerSlab);
    vtkSMPTools::For(slab, slabEnd, classifiedPerTask, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end; ++i) arrays.fill(i, frame, regions);
    });
    this->UpdateProgress(0.5 + 0.5 * slabEnd / count);
  }
  if (this->GetAbortExecute()) return 1;
  output->ShallowCopy(input);
  for (vtkDataArray* array : arrays.all()) output->GetPointData()->AddArray(array);
  vtkNew<vtkStringArray> names;
  names->SetName("RegionName");
  for (int region = 1; region <= mien::FacialRegions::count; ++region) names->InsertNextValue(regions.name(region));
  output->GetFieldData()->AddArray(names);
  KeepWantedPart(outputs->GetInformationObject(0));
  return 1;
}
