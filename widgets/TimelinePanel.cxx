#include "TimelinePanel.h"

#include "AnimationPlayer.h"
#include "ValueSlider.h"
#include "FaceModel.h"
#include "Icons.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVariant>
#include <QToolButton>
#include <QVBoxLayout>

namespace mien {

namespace {

QToolButton* toolButton(QWidget* parent, const char* name, Symbol symbol, const QString& tip) {
  auto* button = new QToolButton(parent);
  button->setObjectName(name);
  button->setIcon(icon(symbol));
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

QLabel* faintLabel(QWidget* parent, const char* name) {
  auto* label = new QLabel(parent);
  label->setObjectName(name);
  label->setProperty("faint", true);
  return label;
}

}  // namespace

TimelinePanel::TimelinePanel(FaceModel* model, AnimationPlayer* player, QWidget* parent)
    : QFrame(parent), model_(model), player_(player), position_(new ValueSlider(this)), frame_(new QSpinBox(this)),
      title_(faintLabel(this, "timelineTitle")), time_(faintLabel(this, "timelineTime")) {
  setObjectName("card");
  buildButtons();
  buildPosition();
  auto* upper = new QHBoxLayout;
  upper->addWidget(title_, 1);
  upper->addWidget(time_);
  upper->addWidget(close_);
  auto* lower = new QHBoxLayout;
  lower->setSpacing(2);
  for (QWidget* widget : {open_, first_, play_, loop_}) lower->addWidget(widget);
  lower->addSpacing(4);
  lower->addWidget(position_, 1);
  lower->addSpacing(4);
  lower->addWidget(frame_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(10, 5, 10, 6);
  column->setSpacing(2);
  column->addLayout(upper);
  column->addLayout(lower);
  connectAll();
  showAnimation();
}

void TimelinePanel::buildButtons() {
  open_ = toolButton(this, "timelineOpen", Symbol::Open, tr("Open a .fap animation (Ctrl+O)"));
  first_ = toolButton(this, "timelineFirst", Symbol::First, tr("First frame"));
  play_ = toolButton(this, "timelinePlay", Symbol::Play, tr("Play or pause (Ctrl+Space)"));
  loop_ = toolButton(this, "timelineLoop", Symbol::Loop, tr("Begin again at the end"));
  close_ = toolButton(this, "timelineClose", Symbol::Close, tr("Close the animation"));
  close_->setIconSize({11, 11});
  loop_->setCheckable(true);
  loop_->setChecked(player_->loops());
}

void TimelinePanel::buildPosition() {
  position_->setObjectName("timelinePosition");
  position_->setSingleStep(1);
  position_->setPageStep(10);
  position_->setAccessibleName(tr("Position in the animation"));
  frame_->setObjectName("timelineFrame");
  frame_->setKeyboardTracking(false);
  frame_->setAlignment(Qt::AlignRight);
  frame_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  frame_->setToolTip(tr("Frame, counted from 1"));
}

void TimelinePanel::connectAll() {
  connect(open_, &QToolButton::clicked, this, &TimelinePanel::openRequested);
  connect(close_, &QToolButton::clicked, model_, &FaceModel::closeAnimation);
  connect(first_, &QToolButton::clicked, this, [this] { player_->seek(0); });
  connect(play_, &QToolButton::clicked, this, [this] { player_->setPlaying(!player_->isPlaying()); });
  connect(loop_, &QToolButton::toggled, player_, &AnimationPlayer::setLoop);
  connect(position_, &QSlider::valueChanged, player_, &AnimationPlayer::seek);
  connect(frame_, QOverload<int>::of(&QSpinBox::valueChanged), this, [this](int frame) { player_->seek(frame - 1); });
  connect(player_, &AnimationPlayer::playingChanged, this, &TimelinePanel::showPlaying);
  connect(model_, &FaceModel::animationChanged, this, &TimelinePanel::showAnimation);
  connect(model_, &FaceModel::animationGrew, this, &TimelinePanel::showAnimation);
  connect(model_, &FaceModel::stateChanged, this, &TimelinePanel::showFrame);
}

void TimelinePanel::showAnimation() {
  const int count = model_->frameCount();
  const QSignalBlocker quietPosition(position_), quietFrame(frame_);
  position_->setRange(0, qMax(1, count - 1));
  frame_->setRange(1, qMax(1, count));
  frame_->setSuffix(count > 0 ? tr(" / %1").arg(count) : QString());
  for (QWidget* widget : {static_cast<QWidget*>(first_), static_cast<QWidget*>(play_), static_cast<QWidget*>(loop_),
                          static_cast<QWidget*>(position_), static_cast<QWidget*>(frame_)})
    widget->setEnabled(count > 0);
  close_->setVisible(count > 0);
  const QFileInfo file(QString::fromStdString(model_->state().fapFile));
  title_->setText(model_->isLive() ? tr("Live stream") : count > 0 ? file.fileName() : tr("No animation. Open a .fap file or drop one on the window."));
  title_->setToolTip(count > 0 && !model_->isLive() ? file.absoluteFilePath() : QString());
  showFrame();
}

void TimelinePanel::showFrame() {
  const int frame = model_->frameIndex();
  const QSignalBlocker quietPosition(position_), quietFrame(frame_);
  position_->setValue(frame);
  position_->setShownValue(frame);
  frame_->setValue(frame + 1);
  const double rate = model_->framesPerSecond();
  if (rate <= 0.0) return time_->clear();
  const double end = (model_->frameCount() - 1) / rate;
  time_->setText(tr("%1 s of %2 s, %3 frames/s, frame number %4")
                     .arg(frame / rate, 0, 'f', 2)
                     .arg(end, 0, 'f', 2)
                     .arg(rate)
                     .arg(model_->frameNumber()));
}

void TimelinePanel::showPlaying(bool playing) { play_->setIcon(icon(playing ? Symbol::Pause : Symbol::Play)); }

}  // namespace mien
