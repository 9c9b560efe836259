#include "FaceModel.h"

#include "AnimationData.h"
#include "FAPSequence.h"
#include "FAPTable.h"
#include "vtkFAPAnimationFilter.h"
#include "vtkFAPReader.h"

#include <QElapsedTimer>
#include <QFileInfo>
#include <QTimer>

#include <algorithm>

namespace mien {

namespace {

QString numbers(const std::vector<int>& values) {
  QStringList texts;
  for (int value : values) texts << QString::number(value);
  return texts.join(", ");
}

}  // namespace

FaceModel::FaceModel(QObject* parent) : QObject(parent), idle_(new QTimer(this)) {
  idle_->setSingleShot(true);
  idle_->setInterval(0);
  connect(idle_, &QTimer::timeout, this, &FaceModel::update);
  pipeline_.updateNeutralCurves();
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
    show(state_);
    emit stateChanged();
    emit failed(fault, tr("The face is as it was before."));
  }
  const bool otherFile = good_.fapFile != state_.fapFile;
  good_ = state_;
  emit updated();
  if (otherFile) reportAnimation();
  return fault.isEmpty();
}

void FaceModel::reportAnimation() {
  emit animationChanged();
  if (frameCount() == 0) return;
  QStringList remarks;
  for (const std::string& warning : pipeline_.frames()->GetWarnings()) remarks << QString::fromStdString(warning);
  const std::vector<int> missing = fapsWithoutSurface(pipeline_.frames()->GetFAPsUsed());
  if (!missing.empty())
    remarks << tr("The face has no surface for FAP %1 (eyeballs, tongue or ears); they are left out.").arg(numbers(missing));
  if (remarks.isEmpty()) return;
  const QString name = QFileInfo(QString::fromStdString(state_.fapFile)).fileName();
  const QString sentence = remarks.size() == 1 ? tr("%1 was opened, with one remark.") : tr("%1 was opened, with %2 remarks.");
  emit remarked(remarks.size() == 1 ? sentence.arg(name) : sentence.arg(name).arg(remarks.size()), remarks.join('\n'));
}

bool FaceModel::openAnimation(const QString& fileName) {
  if (state_.fapFile == fileName.toStdString()) pipeline_.frames()->Modified();  // it may have changed on disk
  change([&](FaceState& state) {
    state.fapFile = fileName.toStdString();
    state.frameChoice = FaceState::FrameChoice::Index;
    state.frame = 0.0;
  });
  return update();
}

void FaceModel::closeAnimation() { openAnimation(QString()); }

int FaceModel::frameCount() const { return good_.fapFile.empty() ? 0 : pipeline_.frames()->GetNumberOfFrames(); }

double FaceModel::framesPerSecond() const {
  return good_.fapFile.empty() ? 0.0 : pipeline_.frames()->GetFramesPerSecond();
}

int FaceModel::frameIndex() const { return static_cast<int>(state_.frame); }

const FAPFrame* FaceModel::frame() const {
  const int last = frameCount() - 1;
  return last < 0 ? nullptr : &pipeline_.frames()->GetSequence().frames[std::clamp(frameIndex(), 0, last)];
}

QString FaceModel::frameNumber() const { return frame() ? QString::number(frame()->number) : QString(); }

void FaceModel::showFrame(int index) {
  if (frameCount() == 0) return;
  change([&](FaceState& state) { state.frame = std::clamp(index, 0, frameCount() - 1); });
}

double FaceModel::shownFAP(int fap) const {
  const auto own = state_.fapValues.find(fap);
  double value = own == state_.fapValues.end() ? 0.0 : own->second;
  if (frame()) value += frame()->value(fap);
  for (const auto& [name, intensity] : state_.expressions)
    value += intensity * vtkFAPAnimationFilter::GetExpressionFAP(name, fap);
  return value;
}

double FaceModel::millimetresPerUnit(int fap) const {
  const FAPUnit unit = fapDefinition(fap).unit;
  return pipeline_.animation()->GetFAPUnit(std::string(symbol(unit))) / distanceUnitDivisor;
}

}  // namespace mien
