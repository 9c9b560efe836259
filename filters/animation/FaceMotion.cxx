#include "FaceMotion.h"

#include <algorithm>

#include "BoundaryCurveData.h"
#include "FacePipeline.h"
#include "LandmarkLines.h"
#include "MotionFieldData.h"
#include "PipelineErrors.h"
#include "vtkFieldData.h"
#include "vtkMotionVectorFilter.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"

namespace mien {

namespace {

// 27 x 6 + 2 rows have every curve among them, and no facets at the outline of a face 170 mm wide.
constexpr int drawnRows = 164, drawnColumns = 160;

FaceState drawnState(FaceState state) {
  state.uniformRows = state.uniformRows && state.rows >= drawnRows;
  state.rows = std::max(state.rows, drawnRows);
  state.columns = std::max(state.columns, drawnColumns);
  return state;
}

}  // namespace

struct FaceMotion::Internals {
  FacePipeline moved, origin, drawn;
  vtkNew<vtkMotionVectorFilter> filter;
  PipelineErrors errors;
  MotionField field;
  FaceCurves originFace;

  Internals() { errors.observe(filter); }

  std::string updateVectors() {
    errors.clear();
    filter->SetInputData(moved.grid());
    filter->SetNeutralData(origin.grid());
    filter->Update();
    if (!errors.first().empty()) filter->Modified();
    return errors.first();
  }

  std::string readOriginFace() {
    auto* curves = vtkPolyData::SafeDownCast(origin.curves()->GetOutputDataObject(0));
    HeadRotation rotation;
    std::string fault = readFaceCurves(curves, originFace);
    if (fault.empty() && filter->GetRemoveHeadRotation()) fault = readHeadRotation(curves->GetFieldData(), rotation);
    rotation.undo(originFace.curves.points);
    return fault;
  }
};

FaceMotion::FaceMotion() : Impl(std::make_unique<Internals>()) {}

FaceMotion::~FaceMotion() = default;

void FaceMotion::setStates(const FaceState& moved, const FaceState& origin) {
  FaceState to = moved, from = origin;
  to.doublePrecision = from.doublePrecision = true;
  from.rows = to.rows;
  from.columns = to.columns;
  from.uniformRows = to.uniformRows;
  Impl->moved.setState(to);
  Impl->origin.setState(from);
  Impl->drawn.setState(drawnState(from));
}

FaceState FaceMotion::neutralOf(const FaceState& state) {
  FaceState neutral = state;
  const FaceState none;
  neutral.fapFile = none.fapFile;
  neutral.frameChoice = none.frameChoice;
  neutral.frame = none.frame;
  neutral.interpolateFrames = none.interpolateFrames;
  neutral.fapValues = none.fapValues;
  neutral.expressions = none.expressions;
  neutral.visemes = none.visemes;
  neutral.deformation = none.deformation;
  return neutral;
}

FacePipeline& FaceMotion::moved() {
  return Impl->moved;
}

FacePipeline& FaceMotion::origin() {
  return Impl->origin;
}

void FaceMotion::setHeadMotionRemoved(bool removed) {
  Impl->filter->SetRemoveHeadRotation(removed);
}

void FaceMotion::setPlane(const PicturePlane& plane) {
  Impl->filter->SetViewDirection(plane.out.x(), plane.out.y(), plane.out.z());
  Impl->filter->SetViewUp(plane.up.x(), plane.up.y(), plane.up.z());
}

std::string FaceMotion::update() {
  for (FacePipeline* pipeline : {&Impl->moved, &Impl->origin, &Impl->drawn}) {
    const std::string fault = pipeline->update();
    if (!fault.empty()) return fault;
  }
  std::string fault = Impl->updateVectors();
  if (fault.empty()) fault = Impl->readOriginFace();
  if (!fault.empty()) return fault;
  fault = readMotionField(Impl->filter->GetOutput(), Impl->origin.grid(), Impl->drawn.grid(),
                          Impl->filter->GetRemoveHeadRotation(), Impl->field);
  if (fault.empty()) Impl->field.landmarks = landmarkLines(Impl->originFace);
  return fault;
}

vtkPolyData* FaceMotion::vectors() const {
  return Impl->filter->GetOutput();
}

const MotionField& FaceMotion::field() const {
  return Impl->field;
}

const FaceCurves& FaceMotion::originFace() const {
  return Impl->originFace;
}

}  // namespace mien
