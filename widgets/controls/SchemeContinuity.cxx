#include "SchemeContinuity.h"

#include <vtkBoundingBox.h>
#include <vtkDataArray.h>
#include <vtkPatchContinuityFilter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkVariant.h>

#include <algorithm>
#include <cmath>

#include "FaceSeams.h"
#include "SurfaceParameters.h"

namespace mien {

SchemeContinuity::SchemeContinuity() {
  errors_.observe(filter_);
}

SchemeContinuity::~SchemeContinuity() = default;

std::string SchemeContinuity::measure(vtkPolyData* curves, const FaceSurfaceOptions& options) {
  errors_.clear();
  scheme_ = options.scheme;
  filter_->SetInputData(curves);
  setParameters(options, filter_);
  filter_->Update();
  const std::string fault = errors_.first();
  valid_ = fault.empty();
  if (!valid_) filter_->Modified();  // after an error VTK does not run a filter again by itself
  return fault;
}

vtkTable* SchemeContinuity::summary() const {
  return filter_->GetSummary();
}

vtkPolyData* SchemeContinuity::seams() const {
  return filter_->GetOutput();
}

int SchemeContinuity::samples() const {
  return filter_->GetNumberOfSamples();
}

std::vector<std::string> SchemeContinuity::seamNames() const {
  std::vector<std::string> names;
  for (int seam = 0; seam < FaceSeams::seamCount; ++seam) names.push_back(FaceSeams::name(seam));
  return names;
}

SeamProfile SchemeContinuity::profile(int seam, const std::string& array) const {
  vtkDataArray* values = seams()->GetPointData()->GetArray(array.c_str());
  vtkDataArray* v = seams()->GetPointData()->GetArray("V");
  SeamProfile profile{scheme_, FaceSeams::name(seam), {}, {}};
  for (int i = 0; i < samples(); ++i) {
    profile.v.push_back(v->GetTuple1(seam * samples() + i) * 180.0 / M_PI);
    profile.value.push_back(values->GetTuple1(seam * samples() + i));
  }
  return profile;
}

std::array<double, 3> SchemeContinuity::pointAt(int seam, double v) const {
  const int sample = std::clamp(static_cast<int>(std::lround(v / 360.0 * samples())), 0, samples() - 1);
  std::array<double, 3> point;
  seams()->GetPoint(seam * samples() + sample, point.data());
  return point;
}

std::array<double, 6> SchemeContinuity::box(int seam) const {
  vtkBoundingBox front, all;
  for (int i = 0; i < samples(); ++i) {
    double point[3];
    seams()->GetPoint(seam * samples() + i, point);
    all.AddPoint(point);
    if (point[2] > FaceSeams::frontalZ) front.AddPoint(point);
  }
  std::array<double, 6> bounds;
  (front.IsValid() ? front : all).GetBounds(bounds.data());
  return bounds;
}

}  // namespace mien
