#include "OriginChooser.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QToolButton>
#include <QVariant>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "FaceModel.h"
#include "FaceMotion.h"
#include "FaceStateJson.h"
#include "Icons.h"

namespace mien {

namespace {

constexpr int neutral = 0, frameBefore = 1, firstPin = 2;  // in the list

/// What is particular about a state: "frame 100, joy 60 %, 3 FAPs"; or "neutral".
QString describe(const FaceModel& model) {
  const FaceState& state = model.state();
  QStringList parts;
  if (model.frameCount() > 0) parts << OriginChooser::tr("frame %1").arg(model.frameNumber());
  for (const auto& [name, intensity] : state.expressions)
    parts << QString("%1 %2 %").arg(QString::fromStdString(name)).arg(qRound(100.0 * intensity));
  for (const auto& [name, strength] : state.visemes)
    parts << QString("%1 %2 %").arg(QString::fromStdString(name)).arg(qRound(100.0 * strength));
  if (!state.fapValues.empty())
    parts << OriginChooser::tr("%n FAP(s)", nullptr, static_cast<int>(state.fapValues.size()));
  return parts.isEmpty() ? OriginChooser::tr("neutral") : parts.join(", ");
}

}  // namespace

OriginChooser::OriginChooser(FaceModel* model, QWidget* parent)
    : QWidget(parent), model_(model), choice_(new QComboBox(this)), unpin_(new QToolButton(this)) {
  setObjectName("vectorsPins");
  choice_->setObjectName("vectorsAgainst");
  choice_->setAccessibleName(tr("Against"));
  choice_->addItems({tr("Neutral face"), tr("Frame before")});
  choice_->setToolTip(
      tr("Where the vectors start: the neutral face, the frame before of the animation, or a state that was pinned"));
  choice_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  auto* pin = new QToolButton(this);
  pin->setObjectName("vectorsPin");
  pin->setText(tr("Pin"));
  pin->setProperty("framed", true);
  pin->setToolTip(tr("Pin this state: keep the face as it is now, with scheme and a, and measure motion against it"));
  pin->setFocusPolicy(Qt::TabFocus);
  unpin_->setObjectName("vectorsUnpin");
  unpin_->setIcon(icon(Symbol::Close));
  unpin_->setIconSize({11, 11});
  unpin_->setToolTip(tr("Forget the chosen pinned state"));
  unpin_->setFocusPolicy(Qt::TabFocus);
  unpin_->setEnabled(false);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  row->addWidget(choice_, 1);
  row->addWidget(pin);
  row->addWidget(unpin_);
  connect(choice_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this](int index) {
    unpin_->setEnabled(index >= firstPin);
    emit changed();
  });
  connect(pin, &QToolButton::clicked, this, &OriginChooser::pin);
  connect(unpin_, &QToolButton::clicked, this, &OriginChooser::unpin);
}

const OriginChooser::Pin* OriginChooser::pinned() const {
  const int number = choice_->currentData().toInt();
  const auto found = std::find_if(pins_.begin(), pins_.end(), [&](const Pin& pin) { return pin.number == number; });
  return found == pins_.end() ? nullptr : &*found;
}

/// The first frame has none before it and does not move.
FaceState OriginChooser::origin() const {
  if (const Pin* pin = pinned()) return pin->state;
  FaceState state = model_->state();
  if (choice_->currentIndex() == neutral || model_->frameCount() == 0) return FaceMotion::neutralOf(state);
  state.frameChoice = FaceState::FrameChoice::Index;
  state.interpolateFrames = false;
  state.frame = std::max(0, model_->frameIndex() - 1);
  return model_->withoutStream(state);
}

bool OriginChooser::isFrameBefore() const {
  return choice_->currentIndex() == frameBefore && model_->frameCount() > 0;
}

QString OriginChooser::originName() const {
  if (const Pin* pin = pinned()) return pin->words;
  return isFrameBefore() ? tr("the frame before") : tr("the neutral face");
}

void OriginChooser::pin() {
  const std::string words = model_->motionText();
  pins_.push_back(
      {++pinCount_, model_->lastingState(), words.empty() ? tr("the neutral face") : QString::fromStdString(words)});
  choice_->addItem(tr("Pin %1: %2").arg(pinCount_).arg(describe(*model_)), pinCount_);
  choice_->setCurrentIndex(choice_->count() - 1);
}

nlohmann::json OriginChooser::sessionState() const {
  nlohmann::json pins = nlohmann::json::array();
  for (const Pin& pin : pins_)
    pins.push_back({{"number", pin.number},
                    {"name", choice_->itemText(choice_->findData(pin.number)).toStdString()},
                    {"words", pin.words.toStdString()},
                    {"face", faceStateJson(pin.state)}});
  return pins;
}

void OriginChooser::forgetAll() {
  pins_.clear();
  pinCount_ = 0;
  while (choice_->count() > firstPin) choice_->removeItem(choice_->count() - 1);
}

void OriginChooser::restoreSession(const nlohmann::json& state) {
  const QString chosen = choice_->currentText();
  forgetAll();
  if (!state.is_array()) return;
  for (const auto& pin : state) {
    FaceState face;
    if (!pin.is_object() || !pin.contains("face") || !readFaceState(pin["face"], face).empty()) continue;
    const auto text = [&](const char* name) {
      return QString::fromStdString(pin.contains(name) && pin[name].is_string() ? pin[name].get<std::string>() : "");
    };
    const bool numbered = pin.contains("number") && pin["number"].is_number_integer();
    const int number = numbered ? pin["number"].get<int>() : pinCount_ + 1;
    pinCount_ = std::max(pinCount_, number);
    pins_.push_back({number, face, text("words")});
    choice_->addItem(text("name"), number);
  }
  choice_->setCurrentIndex(std::max<int>(neutral, choice_->findText(chosen)));
  emit changed();
}

void OriginChooser::unpin() {
  const int number = choice_->currentData().toInt();
  pins_.erase(std::remove_if(pins_.begin(), pins_.end(), [&](const Pin& pin) { return pin.number == number; }),
              pins_.end());
  if (choice_->currentIndex() >= firstPin) choice_->removeItem(choice_->currentIndex());
}

}  // namespace mien
