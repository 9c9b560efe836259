#include "VectorSource.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <utility>

#include "Arguments.h"
#include "CsvText.h"
#include "FAPSequence.h"
#include "FaceMotion.h"
#include "FaceNote.h"
#include "FacePipeline.h"
#include "Failure.h"
#include "FrameOptions.h"
#include "MeshFile.h"
#include "MotionFieldData.h"
#include "NumberText.h"
#include "OutputFile.h"
#include "PipelineErrors.h"
#include "Remarks.h"
#include "SurfaceFile.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFAPReader.h"
#include "vtkIdList.h"
#include "vtkMotionVectorFilter.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"

namespace mien {

namespace {

std::string shortName(const std::string& file) {
  return std::filesystem::path(file).filename().string();
}

constexpr size_t mostFrames = 104;    // (a) .. (z3)
constexpr size_t mostTitledFAPs = 3;  // a title has one line

vtkSmartPointer<vtkPointSet> readPoints(const std::string& name) {
  const auto data = readMesh(name);
  vtkPointSet* points = vtkPointSet::SafeDownCast(data);
  if (!points || points->GetNumberOfPoints() == 0) throw FileFailure(name + ": holds no surface");
  return points;
}

using Pairs = std::vector<std::pair<vtkIdType, vtkIdType>>;

/// All pairs of points that share a polygon, its edges and diagonals, in order.
Pairs pairsOf(vtkPolyData* polygons) {
  Pairs pairs;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < polygons->GetNumberOfCells(); ++cell) {
    polygons->GetCellPoints(cell, ids);
    for (const vtkIdType a : *ids)
      for (const vtkIdType b : *ids) pairs.emplace_back(a, b);
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

/// Whether the polygons of a scan cut up those of the face: its reader makes triangles, along either diagonal.
bool isCutOf(vtkPolyData* scan, vtkPolyData* face) {
  if (scan->GetNumberOfPoints() != face->GetNumberOfPoints()) return false;
  const Pairs ours = pairsOf(face), theirs = pairsOf(scan);
  return std::includes(ours.begin(), ours.end(), theirs.begin(), theirs.end());
}

vtkSmartPointer<vtkPolyData> copyOf(vtkPolyData* data) {
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(data);
  return copy;
}

}  // namespace

VectorSource::VectorSource() : motion_(std::make_unique<FaceMotion>()) {}

VectorSource::~VectorSource() = default;

void VectorSource::addTo(CLI::App& command) {
  command_ = &command;
  command.add_option("surface", surface_, "A moved surface in place of the face, .vts .vtp .ply .obj .stl .off, mm");
  command
      .add_option("--against", against_,
                  "Where the vectors start: neutral, previous (the frame before), the number of a frame of the same "
                  ".fap file, or a surface file of the same topology")
      ->capture_default_str();
  command.add_option("--frames", frames_,
                     "Several frames of the .fap file, numbers as written there, such as 100,120,125 or 100:110");
  command.add_flag("--remove-head-motion", removeHeadMotion_,
                   "Without the rotation of the head (FAPs 48 - 50); of surface files, without their rigid motion");
  options_.addAll(command);
}

VectorSource::Against VectorSource::kind() const {
  if (against_ == "neutral") return Against::Neutral;
  if (against_ == "previous") return Against::Previous;
  return mien::parseNumber(std::string_view(against_)) ? Against::Frame : Against::Mesh;
}

void VectorSource::check() const {
  const auto isGiven = [&](const char* name) { return command_->get_option(name)->count() > 0; };
  const bool hasFile = isGiven("--fap");
  if (!surface_.empty()) {
    if (kind() != Against::Mesh)
      throw ValueFailure("a surface file moves against another one; name it with --against FILE");
    refuseFaceOptions();
    return;
  }
  if (isSeries() && !hasFile) throw ValueFailure("--frames needs an animation; name it with --fap FILE.fap");
  for (const char* const name : {"--frame", "--index", "--time"})
    if (isSeries() && isGiven(name))
      throw ValueFailure(std::string(name) + " and --frames both choose a frame; give one of them");
  if ((kind() == Against::Previous || kind() == Against::Frame) && !hasFile)
    throw ValueFailure("--against " + against_ + " needs an animation; name it with --fap FILE.fap");
  if ((kind() == Against::Previous || kind() == Against::Frame) && options_.state().fapFile == "-")
    throw ValueFailure("--against " + against_ +
                       " needs the animation twice, which --fap - gives once only; write it to a "
                       "file and name that with --fap");
}

/// A surface file has no curves, scheme or animation that they could change.
void VectorSource::refuseFaceOptions() const {
  for (const CLI::Option* option : command_->get_options()) {
    const bool isOfFace = option->get_group() == "Face" || option->get_group() == "Animation";
    const std::string name = option->get_name();
    if (option->count() > 0 && (isOfFace || name == "--frames"))
      throw ValueFailure(name + " describes a face; leave out either it or the surface " + surface_);
  }
}

/// Of a series one for each frame, after the moved pipeline has read the animation.
std::vector<FaceState> VectorSource::states() {
  FaceState state = options_.state();
  if (!isSeries()) return {state};
  motion_->setStates(state, FaceMotion::neutralOf(state));
  checkOrThrow(motion_->moved());
  const FAPSequence& sequence = motion_->moved().frames()->GetSequence();
  std::vector<FaceState> states;
  for (const size_t index : frameIndices("--frames", frames_, sequence)) {
    state.frameChoice = FaceState::FrameChoice::Number;
    state.frame = sequence.frames[index].number;
    states.push_back(state);
  }
  if (states.size() > mostFrames)
    throw ValueFailure("--frames has " + std::to_string(states.size()) + " frames; at most " +
                       std::to_string(mostFrames) + " are drawn");
  return states;
}

std::vector<VectorMoment> VectorSource::moments(const PicturePlane& plane) {
  check();
  std::vector<VectorMoment> moments;
  if (kind() == Against::Mesh) origin_ = readPoints(against_);
  if (!surface_.empty()) {
    moments.push_back(meshMoment(readPoints(surface_), surface_, plane));
    return moments;
  }
  motion_->setPlane(plane);
  motion_->setHeadMotionRemoved(removeHeadMotion_);
  for (const FaceState& state : states())
    moments.push_back(kind() == Against::Mesh ? againstMesh(state, plane) : faceMoment(state));
  for (const VectorMoment& moment : moments) moved_.push_back(moment.frame);
  printRemarks(motion_->moved());
  return moments;
}

const FaceCurves* VectorSource::face() const {
  return hasFace_ ? &motion_->originFace() : nullptr;
}

/// After the moved pipeline has read the animation.
FaceState VectorSource::originOf(const FaceState& state) {
  if (kind() == Against::Neutral) return FaceMotion::neutralOf(state);
  FaceState origin = state;
  origin.frameChoice = FaceState::FrameChoice::Number;
  if (kind() == Against::Frame) origin.frame = parseNumber("--against", against_);
  if (kind() == Against::Frame) return origin;
  const int index = motion_->moved().frames()->GetFrameIndex();
  if (index < 1)
    throw ValueFailure("--against previous: frame " + frameText(state) + " is the first of " + state.fapFile +
                       "; there is none before it");
  origin.frameChoice = FaceState::FrameChoice::Index;
  origin.frame = index - 1;
  return origin;
}

std::string VectorSource::frameText(const FaceState& state) const {
  if (state.fapFile.empty()) return {};
  const int index = motion_->moved().frames()->GetFrameIndex();
  const auto& frames = motion_->moved().frames()->GetSequence().frames;
  return index >= 0 && index < static_cast<int>(frames.size()) ? shortestText(frames[index].number) : std::string();
}

VectorMoment VectorSource::faceMoment(const FaceState& state) {
  motion_->setStates(state, FaceMotion::neutralOf(state));
  checkOrThrow(motion_->moved());
  motion_->setStates(state, originOf(state));
  checkOrThrow(motion_->moved());
  checkOrThrow(motion_->origin());
  const std::string fault = motion_->update();
  if (!fault.empty()) throw FileFailure(fault);
  hasFace_ = true;
  return {frameText(state), state, motion_->field(), copyOf(motion_->vectors())};
}

/// The face as its points and cells compare with those of the surface file: as a grid, or as the polygons that `mien
/// surface` writes, cut into triangles where the file has the same topology but triangles.
vtkSmartPointer<vtkPointSet> VectorSource::movedLike(vtkPointSet* origin) {
  vtkStructuredGrid* grid = motion_->moved().grid();
  if (fileEnding(against_) == "vts") return grid;
  const vtkSmartPointer<vtkPolyData> face = outwardPolygons(grid, false);
  auto* scan = vtkPolyData::SafeDownCast(origin);
  if (!cut_ && scan && isCutOf(scan, face)) cut_ = scan->GetPolys();
  if (!cut_) return face;
  auto cut = vtkSmartPointer<vtkPolyData>::New();
  cut->ShallowCopy(face);
  cut->GetCellData()->Initialize();
  cut->SetPolys(cut_);
  return cut;
}

VectorMoment VectorSource::againstMesh(const FaceState& state, const PicturePlane& plane) {
  motion_->setStates(state, FaceMotion::neutralOf(state));
  checkOrThrow(motion_->moved());
  updateOrThrow(motion_->moved());
  const std::string name = state.curvesFile.empty() ? "the generic face" : state.curvesFile;
  VectorMoment moment = meshMoment(movedLike(origin_), name, plane);
  moment.frame = frameText(state);
  moment.state = state;
  return moment;
}

VectorMoment VectorSource::meshMoment(vtkPointSet* moved, const std::string& name, const PicturePlane& plane) const {
  vtkNew<vtkMotionVectorFilter> filter;
  PipelineErrors errors;
  errors.observe(filter);
  filter->SetInputData(moved);
  filter->SetNeutralData(origin_);
  filter->SetRemoveRigidMotion(removeHeadMotion_);
  filter->SetViewDirection(plane.out.x(), plane.out.y(), plane.out.z());
  filter->SetViewUp(plane.up.x(), plane.up.y(), plane.up.z());
  filter->Update();
  if (!errors.first().empty()) throw FileFailure(name + ", " + against_ + ": " + errors.first());
  VectorMoment moment;
  moment.vectors = filter->GetOutput();
  const std::string fault = readMotionField(moment.vectors, origin_, origin_, false, moment.field);
  if (!fault.empty()) throw FileFailure(against_ + ": " + fault);
  return moment;
}

std::string VectorSource::originName() const {
  switch (kind()) {
    case Against::Neutral:
      return "the neutral face";
    case Against::Previous:
      return "the frame before";
    case Against::Frame:
      return "frame " + against_;
    case Against::Mesh:
      break;
  }
  return shortName(against_);
}

std::string VectorSource::framesName() const {
  std::string name = moved_.size() > 1 ? "frames " : "frame ";
  for (size_t i = 0; i < moved_.size(); ++i) name += (i ? ", " : "") + moved_[i];
  return name;
}

MotionWords VectorSource::words() const {
  MotionWords words;
  words.origin = originName();
  words.headMotionRemoved = removeHeadMotion_;
  if (!surface_.empty()) {
    words.moved = shortName(surface_);
    words.made = shortName(surface_) + " against " + shortName(against_) + "; Mien " MIEN_VERSION;
    return words;
  }
  const FaceState state = options_.state();
  words.moved = motionText(state, framesName(), mostTitledFAPs);
  words.made = faceNote(state, {state.surface.scheme}, true, framesName()) + "; " + std::to_string(state.rows) + " x " +
               std::to_string(state.columns);
  return words;
}

}  // namespace mien
