#include "TimelinePanel.h"

#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <QVariant>

#include "AnimationPlayer.h"
#include "ElidedLabel.h"
#include "FaceModel.h"
#include "FrameBox.h"
#include "FramedButton.h"
#include "Icons.h"
#include "SessionPart.h"
#include "ValueSlider.h"

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

template <class Label>
QLabel* faintLabel(QWidget* parent, const char* name) {
  auto* label = new Label(parent);
  label->setObjectName(name);
  label->setProperty("faint", true);
  return label;
}

}  // namespace

TimelinePanel::TimelinePanel(FaceModel* model, AnimationPlayer* player, QWidget* parent)
    : QFrame(parent),
      model_(model),
      player_(player),
      position_(new ValueSlider(this)),
      frame_(new FrameBox(model, this)),
      title_(faintLabel<ElidedLabel>(this, "timelineTitle")),
      time_(faintLabel<QLabel>(this, "timelineTime")),
      rate_(faintLabel<QLabel>(this, "timelineRate")),
      deck_(new QWidget(this)),
      lower_(new QHBoxLayout(deck_)) {
  setObjectName("timelinePanel");
  setProperty("card", true);
  buildButtons();
  buildPosition();
  buildRange();
  buildSpeed();
  auto* upper = new QHBoxLayout;
  upper->addWidget(open_);
  upper->addWidget(title_, 1);
  upper->addWidget(time_);
  upper->addWidget(rate_);
  upper->addWidget(demonstration_);
  upper->addWidget(close_);
  lower_->setContentsMargins(0, 0, 0, 0);
  lower_->setSpacing(2);
  for (QWidget* widget : {first_, play_, loop_, in_, out_}) lower_->addWidget(widget);
  lower_->addSpacing(4);
  lower_->addWidget(position_, 1);
  lower_->addSpacing(4);
  for (QWidget* widget : {static_cast<QWidget*>(frame_), static_cast<QWidget*>(speed_), static_cast<QWidget*>(smooth_)})
    lower_->addWidget(widget);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(10, 3, 10, 3);
  column->setSpacing(2);
  column->addLayout(upper);
  column->addWidget(deck_);
  connectAll();
  connectRange();
  showAnimation();
}

void TimelinePanel::addButton(QToolButton* button) {
  lower_->addWidget(button);
}

void TimelinePanel::buildButtons() {
  open_ = toolButton(this, "timelineOpen", Symbol::Open, tr("Open a .fap animation (Ctrl+O)"));
  first_ = toolButton(this, "timelineFirst", Symbol::First, tr("First frame"));
  play_ = toolButton(this, "timelinePlay", Symbol::Play, tr("Play or pause (Ctrl+Space)"));
  loop_ = toolButton(this, "timelineLoop", Symbol::Loop, tr("Begin again at the end"));
  close_ = toolButton(this, "timelineClose", Symbol::Close, tr("Close the animation"));
  close_->setIconSize({11, 11});
  demonstration_ = new QToolButton(this);
  makeFramed(demonstration_, "timelineDemonstration", tr("Play the demonstration"),
             tr("Opens and plays the animation that comes with Mien"));
  loop_->setCheckable(true);
  loop_->setChecked(player_->loops());
}

void TimelinePanel::buildPosition() {
  position_->setObjectName("timelinePosition");
  position_->setSingleStep(1);
  position_->setPageStep(10);
  position_->setAccessibleName(tr("Position in the animation"));
  position_->setToolTip(tr("The frame that is shown; arrow keys step by one, Page up and down by ten"));
  for (QWidget* widget : {static_cast<QWidget*>(position_), static_cast<QWidget*>(frame_)})
    widget->setProperty(notInSession, true);  // the state has the frame
  frame_->setObjectName("timelineFrame");
}

void TimelinePanel::buildRange() {
  const auto make = [this](const char* name, const QString& text, const QString& tip) {
    auto* button = new QToolButton(this);
    button->setObjectName(name);
    button->setText(text);
    button->setToolTip(tip);
    button->setCheckable(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setProperty(notInSession, true);  // the player has the range, the state the interpolation
    return button;
  };
  in_ = make("timelineIn", tr("In"), tr("The range to play begins at this frame; again: at the first"));
  out_ = make("timelineOut", tr("Out"), tr("The range to play ends at this frame; again: at the last"));
  smooth_ = make("timelineSmooth", tr("Interpolate"),
                 tr("Show the face between two frames too, as their linear mixture; else only the frames of the file"));
}

void TimelinePanel::buildSpeed() {
  speed_ = new QComboBox(this);
  speed_->setObjectName("timelineSpeed");
  speed_->setToolTip(tr("Speed of playing, as a multiple of the file's own"));
  speed_->setAccessibleName(tr("Speed"));
  for (double speed : {0.1, 0.25, 0.5, 1.0, 2.0, 4.0}) speed_->addItem(QString("%1\u00d7").arg(speed), speed);
  speed_->setCurrentIndex(speed_->findData(1.0));
}

void TimelinePanel::connectRange() {
  connect(in_, &QToolButton::clicked, this, [this](bool on) {
    const int frame = model_->frameIndex();
    player_->setRange(on ? frame : 0,
                      on && frame > player_->rangeEnd() ? model_->frameCount() - 1 : player_->rangeEnd());
  });
  connect(out_, &QToolButton::clicked, this, [this](bool on) {
    const int frame = model_->frameIndex();
    player_->setRange(on && frame < player_->rangeBegin() ? 0 : player_->rangeBegin(),
                      on ? frame : model_->frameCount() - 1);
  });
  connect(speed_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          [this] { player_->setSpeed(speed_->currentData().toDouble()); });
  connect(smooth_, &QToolButton::clicked, model_, &FaceModel::setInterpolating);
  connect(player_, &AnimationPlayer::rangeChanged, this, &TimelinePanel::showRange);
  connect(player_, &AnimationPlayer::rateMeasured, this,
          [this](double rate) { rate_->setText(tr("\u00b7 %1 frames/s drawn").arg(rate, 0, 'f', 0)); });
  connect(player_, &AnimationPlayer::playingChanged, rate_, &QLabel::clear);
}

void TimelinePanel::showRange() {
  const QSignalBlocker quietIn(in_), quietOut(out_);
  in_->setChecked(player_->rangeBegin() > 0);
  out_->setChecked(player_->rangeEnd() + 1 < model_->frameCount());
  position_->setRangeMarks(
      player_->hasRange() ? std::make_optional(qMakePair(player_->rangeBegin(), player_->rangeEnd())) : std::nullopt);
}

void TimelinePanel::connectAll() {
  connect(open_, &QToolButton::clicked, this, &TimelinePanel::openRequested);
  connect(demonstration_, &QToolButton::clicked, this, &TimelinePanel::demonstrationRequested);
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
  frame_->follow();
  for (QWidget* widget : {static_cast<QWidget*>(first_), static_cast<QWidget*>(play_), static_cast<QWidget*>(loop_),
                          static_cast<QWidget*>(position_), static_cast<QWidget*>(frame_), static_cast<QWidget*>(in_),
                          static_cast<QWidget*>(out_)})
    widget->setEnabled(count > 0);
  const bool isOpen = count > 0 || model_->isLive();
  close_->setVisible(count > 0);
  for (QWidget* widget : {static_cast<QWidget*>(deck_), static_cast<QWidget*>(time_), static_cast<QWidget*>(rate_)})
    widget->setVisible(isOpen);
  demonstration_->setVisible(!isOpen);
  const QFileInfo file(QString::fromStdString(model_->state().fapFile));
  title_->setText(model_->isLive() ? tr("Live stream")
                  : count > 0      ? file.fileName()
                                   : tr("No animation. Open a .fap file or drop one on the window."));
  title_->setToolTip(count > 0 && !model_->isLive() ? file.absoluteFilePath() : QString());
  showFrame();
}

void TimelinePanel::showFrame() {
  const int frame = model_->frameIndex();
  const QSignalBlocker quietPosition(position_), quietFrame(frame_);
  position_->setValue(frame);
  position_->setShownValue(frame);
  smooth_->setChecked(model_->interpolates());
  frame_->setValue(frame + 1);
  const double rate = model_->framesPerSecond();
  if (rate <= 0.0) return time_->clear();
  const double end = (model_->frameCount() - 1) / rate;
  time_->setText(tr("%1 s of %2 s \u00b7 %3 frames/s")
                     .arg(model_->framePosition() / rate, 0, 'f', 2)
                     .arg(end, 0, 'f', 2)
                     .arg(rate));
}

void TimelinePanel::showPlaying(bool playing) {
  play_->setIcon(icon(playing ? Symbol::Pause : Symbol::Play));
}

}  // namespace mien
