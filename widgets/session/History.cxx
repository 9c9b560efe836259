#include "History.h"

#include <QApplication>
#include <QMouseEvent>
#include <QTimer>
#include <QUndoCommand>
#include <QUndoStack>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "AnimationPlayer.h"
#include "ChangeText.h"
#include "FaceModel.h"
#include "Session.h"
#include "SessionText.h"

namespace mien {

namespace {

using json = nlohmann::json;

constexpr int mostSteps = 10000;
constexpr int settling = 300;  // ms after which what changed by itself is looked at
constexpr int pressing = 200;  // ms that a shortcut may take: Qt shows its button pressed for 100 ms before it acts

/// Whether two changes are of the same numbers or texts. Ticks and what is pressed are separate acts.
bool isSameKind(const json& one, const json& other) {
  if (one.is_object() && other.is_object()) {
    if (one.size() != other.size()) return false;
    return std::equal(one.items().begin(), one.items().end(), other.items().begin(), [](const auto& a, const auto& b) {
      return a.key() == b.key() && isSameKind(a.value(), b.value());
    });
  }
  const auto isMergeable = [](const json& value) { return value.is_number() || value.is_string() || value.is_null(); };
  return isMergeable(one) && isMergeable(other);
}

}  // namespace

/// Kept as what differs, so that a long history stays small.
class History::Step : public QUndoCommand {
 public:
  Step(History& history, const json& now, Input input, bool follows)
      : history_(history),
        undo_(jsonDifference(now, *history.present_)),
        redo_(jsonDifference(*history.present_, now)),
        input_(input),
        follows_(follows) {
    age_.start();
    setText(changeText(redo_, *history.session_->parent()));
  }

  int id() const override { return 1; }
  void undo() override { history_.apply(undo_); }
  void redo() override {
    if (isShown_) history_.apply(redo_);
    isShown_ = true;  // when it is pushed it has happened already
  }

  bool mergeWith(const QUndoCommand* command) override {
    const auto& next = *static_cast<const Step*>(command);
    if (!next.follows_ && !continuesIn(next)) return false;
    json before = *history_.present_;
    before.merge_patch(undo_);
    undo_ = jsonDifference(*history_.arriving_, before);
    redo_ = jsonDifference(before, *history_.arriving_);
    setObsolete(redo_.empty());
    if (!next.follows_) age_.restart();
    return true;
  }

 private:
  bool continuesIn(const Step& next) const {
    return input_ == Input::Keys && next.input_ == Input::Keys && age_.elapsed() < together &&
           isSameKind(redo_, next.redo_);
  }

  History& history_;
  json undo_, redo_;
  Input input_;
  bool follows_, isShown_ = false;
  QElapsedTimer age_;
};

History::History(Session* session, FaceModel* model, AnimationPlayer* player)
    : QObject(session),
      session_(session),
      model_(model),
      player_(player),
      steps_(new QUndoStack(this)),
      idle_(new QTimer(this)),
      later_(new QTimer(this)),
      present_(std::make_unique<json>(session->undoable())) {
  steps_->setUndoLimit(mostSteps);
  for (QTimer* timer : {idle_, later_}) {
    timer->setSingleShot(true);
    connect(timer, &QTimer::timeout, this, &History::record);
  }
  later_->setInterval(settling);
  connect(model, &FaceModel::updated, this, [this] {
    if (input_ != Input::None) return idle_->start();
    if (!later_->isActive()) later_->start();
  });
  connect(steps_, &QUndoStack::indexChanged, this, &History::changed);
  connect(steps_, &QUndoStack::cleanChanged, this, &History::changed);
  qApp->installEventFilter(this);
}

History::~History() = default;

/// What has changed before belongs to what the user did before.
void History::note(Input input) {
  if (input_ == Input::None) record();
  input_ = input;
  away_ = false;
  idle_->start(input == Input::Command ? pressing : 0);
}

bool History::eventFilter(QObject* watched, QEvent* event) {
  if (!watched->isWidgetType()) return false;
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
      note(Input::Mouse);
      held_ = true;
      break;
    case QEvent::MouseMove:  // a drag from window to window swallows the release
      if (!held_ || static_cast<QMouseEvent*>(event)->buttons() != Qt::NoButton) break;
      [[fallthrough]];
    case QEvent::MouseButtonRelease:
    case QEvent::Drop:
      held_ = false;
      note(Input::Mouse);
      break;
    case QEvent::ShortcutOverride:  // comes before each key; one that is a shortcut is not pressed for a widget then
      record();
      note(Input::Command);
      break;
    case QEvent::KeyRelease:
      if (input_ == Input::None) note(Input::Command);
      break;
    case QEvent::KeyPress:
    case QEvent::Wheel:
      note(Input::Keys);
      break;
    case QEvent::WindowDeactivate:
      away_ = away_ || watched == session_->parent();
      break;
    default:
      break;
  }
  return false;
}

void History::record() {
  if (held_ || applying_) return;
  if (!model_->isSettled()) model_->update();  // here, as a film that plays never lets the event loop rest
  const json now = session_->undoable();
  const bool follows = input_ == Input::None && !away_;
  if (player_->isPlaying() || follows) followFrame(now);
  followKnown(now);
  if (now != *present_) push(now, follows);
  *present_ = now;
  input_ = Input::None;
}

/// Frames that come by themselves are no steps.
void History::followFrame(const json& now) {
  const auto from = now["face"].find("animation");
  if (from == now["face"].end() || !present_->at("face").contains("animation")) return;
  json& known = (*present_)["face"]["animation"];
  for (const char* key : {"index", "time", "frame"})
    if (known.contains(key) && from->contains(key)) known[key] = from->at(key);
}

/// A list that is filled, or a dock that is made, at first use changes nothing.
void History::followKnown(const json& now) {
  json& known = (*present_)["docks"];
  for (const auto& dock : now["docks"].items()) {
    json& settings = known[dock.key()];
    for (const auto& setting : dock.value().items())
      if (!settings.contains(setting.key())) settings[setting.key()] = setting.value();
  }
}

/// A consequence of what was undone, or opened, is no step: it would take away what can be redone.
void History::push(const json& now, bool follows) {
  if (follows && (steps_->isClean() || steps_->canRedo())) return;
  arriving_ = &now;
  steps_->push(new Step(*this, now, input_, follows));
  arriving_ = nullptr;
  away_ = false;
  emit changed();
}

void History::apply(const json& change) {
  applying_ = true;
  emit travels();
  json wanted = *present_;
  wanted.merge_patch(change);
  session_->restore(wanted);
  *present_ = session_->undoable();
  applying_ = false;
}

void History::act() {
  if (applying_) return;
  if (input_ == Input::None) input_ = Input::Mouse;
  idle_->start(0);
}

void History::undo() {
  if (held_) return;
  record();
  steps_->undo();
}

void History::redo() {
  if (held_) return;
  record();
  steps_->redo();
}

void History::clear() {
  if (!model_->isSettled()) model_->update();
  *present_ = session_->undoable();
  input_ = Input::None;
  steps_->clear();
  emit changed();
}

void History::clearAsModified() {
  clear();
  steps_->resetClean();
  emit changed();
}

int History::count() const {
  return steps_->count();
}

bool History::isClean() const {
  return steps_->isClean();
}

void History::setClean() {
  record();
  steps_->setClean();
}

QString History::undoText() const {
  return steps_->canUndo() ? steps_->undoText() : QString();
}

QString History::redoText() const {
  return steps_->canRedo() ? steps_->redoText() : QString();
}

}  // namespace mien
