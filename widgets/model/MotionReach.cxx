#include "MotionReach.h"

#include <vtkAlgorithm.h>
#include <vtkMath.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <limits>
#include <set>

#include "CurveMovement.h"
#include "FAPSequence.h"
#include "FaceMotion.h"
#include "FacePipeline.h"

namespace mien {

namespace {

constexpr double slack = 0.5;  // mm: less does not move the camera
constexpr size_t between = 48;
constexpr double half = 0.70710678118654752;

/// Along the axes of the views from the front, 45 degrees and the side.
constexpr double directions[][3] = {{1.0, 0.0, 0.0},    {-1.0, 0.0, 0.0},  {0.0, 1.0, 0.0},   {0.0, -1.0, 0.0},
                                    {0.0, 0.0, 1.0},    {0.0, 0.0, -1.0},  {half, 0.0, half}, {-half, 0.0, -half},
                                    {half, 0.0, -half}, {-half, 0.0, half}};

/// The frames in which a FAP is at one of its ends, and some evenly between: a head that nods reaches furthest on the
/// way.
std::set<size_t> extremeFrames(const FAPSequence& motion) {
  std::set<size_t> frames;
  for (int fap : motion.fapsUsed()) {
    size_t least = 0, most = 0;
    for (size_t i = 1; i < motion.frames.size(); ++i) {
      if (motion.frames[i].value(fap) < motion.frames[least].value(fap)) least = i;
      if (motion.frames[i].value(fap) > motion.frames[most].value(fap)) most = i;
    }
    frames.insert({least, most});
  }
  for (size_t i = 0; i < between && !motion.frames.empty(); ++i)
    frames.insert(i * (motion.frames.size() - 1) / (between - 1));
  return frames;
}

vtkPolyData* curvesOf(const FacePipeline& pipeline) {
  return vtkPolyData::SafeDownCast(pipeline.curves()->GetOutputDataObject(0));
}

double mostMovement(vtkPolyData* curves, bool withHead) {
  const auto movement = curveMovement(curves, !withHead);
  return movement && movement->GetNumberOfTuples() > 0 ? movement->GetRange()[1] : 0.0;
}

}  // namespace

MotionReach::MotionReach() : probe_(std::make_unique<FacePipeline>()) {}

MotionReach::~MotionReach() = default;

void MotionReach::plan(const FaceState& face, const FAPSequence& motion) {
  points_.assign(std::size(directions), Point());
  reach_.assign(std::size(directions), -std::numeric_limits<double>::infinity());
  movement_ = {};
  FaceState state = FaceMotion::neutralOf(face);
  const auto show = [&] {
    probe_->setState(state);
    if (!probe_->updateCurves().empty()) return;
    take(curvesOf(*probe_));
    for (const bool withHead : {false, true})
      movement_[withHead] = std::max(movement_[withHead], mostMovement(curvesOf(*probe_), withHead));
  };
  show();
  for (size_t index : extremeFrames(motion)) {
    state.fapValues.clear();
    for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count; ++fap)
      if (const double value = motion.frames[index].value(fap); value != 0.0) state.fapValues[fap] = value;
    show();
  }
  grown_ = false;
}

bool MotionReach::add(const FacePipeline& shown) {
  const bool grows = take(curvesOf(shown));
  grown_ |= grows;
  return grows;
}

bool MotionReach::take(vtkPolyData* curves) {
  bool grows = false;
  for (vtkIdType i = 0; curves && i < curves->GetNumberOfPoints(); ++i) {
    Point point;
    curves->GetPoint(i, point.data());
    for (size_t d = 0; d < reach_.size(); ++d) {
      const double reach = vtkMath::Dot(directions[d], point.data());
      if (!(reach > reach_[d] + slack)) continue;
      reach_[d] = reach;
      points_[d] = point;
      grows = true;
    }
  }
  return grows;
}

}  // namespace mien
