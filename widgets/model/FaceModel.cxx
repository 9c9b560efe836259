#include "FaceModel.h"

#include <QElapsedTimer>
#include <QFileInfo>
#include <QTimer>
#include <algorithm>
#include <cmath>

#include "AnimationData.h"
#include "FAPTable.h"
#include "FaceNote.h"
#include "HighLevelFAPs.h"
#include "MotionReach.h"
#include "MouthSack.h"
#include "NamedTables.h"
#include "PipelineErrors.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkFAPAnimationFilter.h"
#include "vtkFAPReader.h"
#include "vtkPolyData.h"

namespace mien {

namespace {

constexpr int headGroup = 7;          // of the standard
constexpr size_t mostTitledFAPs = 3;  // of more only their number is told

QString numbers(const std::vector<int>& values) {
  QStringList texts;
  for (int value : values) texts << QString::number(value);
  return texts.join(", ");
}

/// What parts of a head these FAPs move that a face does not have: "eyeballs, tongue".
QString missingParts(const std::vector<int>& faps) {
  QStringList parts;
  for (int fap : faps) {
    const int group = fapDefinition(fap).group;
    const QString part = group == 3   ? FaceModel::tr("eyeballs")
                         : group == 6 ? FaceModel::tr("tongue")
                                      : FaceModel::tr("ears");
    if (!parts.contains(part)) parts << part;
  }
  return parts.join(", ");
}

/// What is wrong with a file that is open already and may have changed since, or nothing.
QString faultOnDisk(const QString& fileName) {
  vtkNew<vtkFAPReader> reader;
  PipelineErrors errors;
  errors.observe(reader);
  reader->SetFileName(fileName.toStdString().c_str());
  reader->UpdateInformation();
  return QString::fromStdString(errors.first());
}

}  // namespace

FaceModel::FaceModel(QObject* parent)
    : QObject(parent), idle_(new QTimer(this)), reach_(std::make_unique<MotionReach>()) {
  idle_->setSingleShot(true);
  idle_->setInterval(0);
  connect(idle_, &QTimer::timeout, this, &FaceModel::update);
  pipeline_.updateNeutralCurves();
  reach_->plan(state_, motion_);
  followTable();
  update();
}

FaceModel::~FaceModel() = default;

void FaceModel::change(const std::function<void(FaceState&)>& edit) {
  FaceState changed = state_;
  edit(changed);
  if (changed == state_) return;
  state_ = changed;
  idle_->start();
  emit stateChanged();
}

QString FaceModel::show(const FaceState& state) {
  pipeline_.setState(state);
  return QString::fromStdString(pipeline_.update());
}

bool FaceModel::update() {
  idle_->stop();
  QElapsedTimer clock;
  clock.start();
  const QString fault = show(state_);
  pipelineTime_ = clock.nsecsElapsed() * 1e-6;
  if (!fault.isEmpty()) {
    state_ = good_;
    reopened_ = false;
    show(state_);
    emit stateChanged();
    emit failed(fault, tr("The face is as it was before."));
  }
  accept();
  return fault.isEmpty();
}

bool FaceModel::isSettled() const {
  return !idle_->isActive();
}

void FaceModel::accept() {
  const bool otherFile = reopened_ || good_.fapFile != state_.fapFile || isReadAnew();
  const bool otherFace = good_.curvesFile != state_.curvesFile;
  const bool otherTable = good_.animationTable != state_.animationTable;
  FaceState before = good_;
  before.frame = state_.frame;
  const bool changed = before != state_;
  good_ = state_;
  reopened_ = false;
  if (otherFile || otherFace) followAnimation();
  if (otherTable) followTable();
  followReach();
  emit updated();
  if (changed) emit recovered();
  if (otherFile) emit animationChanged();
  if (otherFile && frameCount() > 0) reportAnimation();
}

/// The reader looks at the file again after a failure anywhere.
bool FaceModel::isReadAnew() const {
  return !state_.fapFile.empty() && motion_.frames.size() != pipeline_.frames()->GetSequence().frames.size();
}

void FaceModel::followAnimation() {
  motion_ = good_.fapFile.empty() ? FAPSequence() : pipeline_.frames()->GetSequence();
  for (FAPFrame& frame : motion_.frames) resolveHighLevelFAPs(defaultVisemes(), defaultExpressions(), frame);
  const std::vector<int> still = good_.fapFile.empty() ? std::vector<int>() : stillFAPs();
  reported_ = {still.begin(), still.end()};
  reach_->plan(withoutStream(good_), motion_);
  emit reachChanged();
}

/// A face at rest fills the view again, whatever it did before.
void FaceModel::followReach() {
  const bool rests =
      good_.fapFile.empty() && good_.fapValues.empty() && good_.expressions.empty() && good_.visemes.empty();
  const bool shrinks = rests && reach_->hasGrown();
  if (shrinks) reach_->plan(good_, motion_);
  if (reach_->add(pipeline_) || shrinks) emit reachChanged();
}

/// The pipeline has read the table already, so there is no fault left to report.
void FaceModel::followTable() {
  readAnimationTable(good_.animationTable, table_);
  emit tableChanged();
}

bool FaceModel::moves(int fap) const {
  if (fap < FAPFrame::firstLowLevel) return true;
  const bool turnsHead = fapDefinition(fap).group == headGroup;  // the head's rotation needs no points
  return fapDefinition(fap).hasSurface && (turnsHead || table_.entry(fap));
}

std::vector<int> FaceModel::stillFAPs() const {
  std::vector<int> still;
  for (int fap : pipeline_.frames()->GetFAPsUsed())
    if (!moves(fap)) still.push_back(fap);
  return still;
}

/// The file's FAPs that move nothing, as a sentence; or nothing.
QString FaceModel::stillText() const {
  const std::vector<int> still = stillFAPs(), missing = fapsWithoutSurface(still);
  std::vector<int> unknown;
  std::set_difference(still.begin(), still.end(), missing.begin(), missing.end(), std::back_inserter(unknown));
  QStringList parts;
  if (!missing.empty())
    parts << tr("FAP %1 (%2), which this face has no surface for").arg(numbers(missing), missingParts(missing));
  if (!unknown.empty()) parts << tr("FAP %1, which the animation table does not move").arg(numbers(unknown));
  return parts.isEmpty() ? QString() : tr("It also sets %1.").arg(parts.join(tr(", and ")));
}

void FaceModel::reportAnimation() {
  const QString still = stillText();
  const QString name = isLive() ? tr("The stream") : QFileInfo(QString::fromStdString(state_.fapFile)).fileName();
  QStringList remarks;
  for (const std::string& warning : pipeline_.frames()->GetWarnings()) remarks << QString::fromStdString(warning);
  if (remarks.isEmpty()) {
    if (!still.isEmpty()) emit remarked(tr("%1 was opened. %2").arg(name, still), QString());
    return;
  }
  if (!still.isEmpty()) remarks << still;
  const QString sentence =
      remarks.size() == 1 ? tr("%1 was opened, with one remark.") : tr("%1 was opened, with %2 remarks.");
  emit remarked(remarks.size() == 1 ? sentence.arg(name) : sentence.arg(name).arg(remarks.size()), remarks.join('\n'));
}

bool FaceModel::openAnimation(const QString& fileName) {
  const bool again = !fileName.isEmpty() && fileName != "-" && state_.fapFile == fileName.toStdString();
  const QString fault = again ? faultOnDisk(fileName) : QString();
  if (!fault.isEmpty()) {
    emit failed(fault, tr("The face is as it was before."));
    return false;
  }
  if (again) pipeline_.frames()->Modified();
  reopened_ = again;
  change([&](FaceState& state) {
    state.fapFile = fileName.toStdString();
    state.frame = 0.0;
  });
  const bool good = update();
  if (good) emit recovered();
  return good;
}

void FaceModel::appendLive(double framesPerSecond, const QString& name, const std::vector<FAPFrame>& frames) {
  const bool isFirst = !isLive();
  if (isFirst) pipeline_.frames()->StartStream(framesPerSecond, name.toStdString());
  FAPSequence batch;
  batch.frames = frames;
  for (FAPFrame frame : frames) {
    pipeline_.frames()->AppendFrame(frame);
    resolveHighLevelFAPs(defaultVisemes(), defaultExpressions(), frame);
    if (!isFirst) motion_.frames.push_back(frame);
  }
  if (isFirst) openAnimation("-");
  bool news = false;
  for (int fap : batch.fapsUsed()) news |= !moves(fap) && reported_.insert(fap).second;
  if (news) emit remarked(tr("The stream goes on. %1").arg(stillText()), QString());
  emit animationGrew();
}

FaceState FaceModel::withoutStream(FaceState state) const {
  if (state.fapFile != "-") return state;
  const FaceState none;
  const bool isTime = state.frameChoice == FaceState::FrameChoice::Time;
  const double time = isTime ? state.frame : state.frame / motion_.framesPerSecond;
  const FAPFrame frame = motion_.frames.empty() ? FAPFrame() : motion_.frameAtTime(time, state.interpolateFrames);
  for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count; ++fap)
    if (const double value = frame.value(fap); value != 0.0)
      state.fapValues[fap] =
          std::clamp(state.fapValues[fap] + value, -FaceState::largestFAPValue, FaceState::largestFAPValue);
  state.fapFile = none.fapFile;
  state.frameChoice = none.frameChoice;
  state.frame = none.frame;
  state.interpolateFrames = none.interpolateFrames;
  return state;
}

/// Read before, so that a file with a fault changes nothing. One that is open already goes away and comes back, as it
/// may have changed on disk.
bool FaceModel::takeTable(const std::string& name, const std::string& fault,
                          const std::function<std::string&(FaceState&)>& part) {
  if (!fault.empty()) {
    emit failed(QString::fromStdString(fault), tr("The face is as it was before."));
    return false;
  }
  const auto choose = [&](const std::string& chosen) {
    change([&](FaceState& state) { part(state) = chosen; });
    return update();
  };
  FaceState now = state_;
  if (part(now) == name) choose({});
  return choose(name);
}

bool FaceModel::openAnimationTable(const QString& fileName) {
  AnimationTable table;
  const std::string name = fileName.toStdString();
  return takeTable(name, readAnimationTable(name, table),
                   [](FaceState& state) -> std::string& { return state.animationTable; });
}

bool FaceModel::openDeformationTable(const QString& nameOrFile) {
  DeformationTable table;
  const std::string name = nameOrFile.toStdString();
  return takeTable(name, readNamedTable(name, table),
                   [](FaceState& state) -> std::string& { return state.deformation.table; });
}

bool FaceModel::openCurves(const QString& fileName) {
  pipeline_.neutralCurves()->Modified();  // they may have been read under this name before
  change([&](FaceState& state) {
    state.curvesFile = fileName.toStdString();
    state.edits.clear();
  });
  return update();
}

void FaceModel::closeAnimation() {
  openAnimation(QString());
}

int FaceModel::frameCount() const {
  return good_.fapFile.empty() ? 0 : pipeline_.frames()->GetNumberOfFrames();
}

double FaceModel::framesPerSecond() const {
  return good_.fapFile.empty() ? 0.0 : pipeline_.frames()->GetFramesPerSecond();
}

double FaceModel::framePosition() const {
  const bool isTime = state_.frameChoice == FaceState::FrameChoice::Time;
  return isTime ? state_.frame * motion_.framesPerSecond : state_.frame;
}

/// Half a millionth of a frame is rounding of a time, as in FAPSequence.
int FaceModel::frameIndex() const {
  return static_cast<int>(std::floor(framePosition() + 1e-6));
}

std::string FaceModel::frameText() const {
  return frameCount() > 0 ? "frame " + frameNumber().toStdString() : std::string();
}

vtkPolyData* FaceModel::mouth() {
  auto* curves = vtkPolyData::SafeDownCast(pipeline_.shownCurves()->GetOutputDataObject(0));
  const vtkMTimeType now = curves ? curves->GetMTime() : 0;
  if (!mouth_ || mouthTime_ != now) mouth_ = mouthSack(curves);
  mouthTime_ = now;
  return mouth_;
}

std::string FaceModel::motionText() const {
  return mien::motionText(state(), frameText(), mostTitledFAPs);
}

QString FaceModel::frameNumber() const {
  const int last = static_cast<int>(motion_.frames.size()) - 1;
  return last < 0 || frameCount() == 0 ? QString()
                                       : QString::number(motion_.frames[std::clamp(frameIndex(), 0, last)].number);
}

void FaceModel::showFrame(double position) {
  if (frameCount() == 0) return;
  const double kept = std::clamp(position, 0.0, frameCount() - 1.0);
  change([&](FaceState& state) { state.frame = interpolates() ? kept / framesPerSecond() : std::floor(kept); });
}

void FaceModel::setInterpolating(bool on) {
  const double position = framePosition();
  change([&](FaceState& state) {
    state.interpolateFrames = on;
    state.frameChoice = on ? FaceState::FrameChoice::Time : FaceState::FrameChoice::Index;
    state.frame = on ? position / motion_.framesPerSecond : std::floor(position);
  });
}

double FaceModel::shownFAP(int fap) const {
  const auto own = state_.fapValues.find(fap);
  double value = own == state_.fapValues.end() ? 0.0 : own->second;
  if (frameCount() > 0)
    value += motion_.frameAtTime(framePosition() / motion_.framesPerSecond, interpolates()).value(fap);
  for (const auto& [name, intensity] : state_.expressions)
    value += intensity * vtkFAPAnimationFilter::GetExpressionFAP(name, fap);
  FAPFrame spoken;
  for (const auto& [name, strength] : state_.visemes) defaultVisemes().add(name, strength, spoken);
  value += spoken.value(fap);
  return value;
}

double FaceModel::millimetresPerUnit(int fap) const {
  const FAPUnit unit = fapDefinition(fap).unit;
  return pipeline_.animation()->GetFAPUnit(std::string(symbol(unit))) / distanceUnitDivisor;
}

}  // namespace mien
