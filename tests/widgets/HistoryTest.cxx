#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QToolButton>
#include <QWheelEvent>
#include <nlohmann/json.hpp>
#include <random>

#include "AnimationPlayer.h"
#include "ChangeText.h"
#include "Comparison.h"
#include "FaceModel.h"
#include "FaceScheme.h"
#include "FaceStateText.h"
#include "History.h"
#include "StudioFixture.h"
#include "ViewArea.h"
#include "WidgetSettings.h"

namespace {

using json = nlohmann::json;
using mien::FaceState;
using mien::WidgetSettings;

class History : public StudioFixture {
 protected:
  History() { QApplication::setActiveWindow(window.get()); }  // for shortcuts; there is no window manager

  mien::History& history() { return window->history(); }
  json settings() { return WidgetSettings::read(*window, WidgetSettings::Of::Undo); }
  std::string state() { return mien::writeFaceState(window->model().state()); }

  /// Where a click does nothing: what changes next is the user's own act.
  void touch() { QTest::mouseClick(find<QLabel>("fapHeading8"), Qt::LeftButton); }

  void wheel(QWidget* widget, int steps) {
    const QPointF middle = widget->rect().center();
    QWheelEvent turn(middle, widget->mapToGlobal(middle.toPoint()), {}, {0, 120 * steps}, Qt::NoButton, Qt::NoModifier,
                     Qt::NoScrollPhase, false);
    QApplication::sendEvent(widget, &turn);
    settle();
  }

  QString undoText() { return find<QAction>("actionUndo")->text(); }
};

TEST_F(History, HasNothingToUndoAtTheStart) {
  EXPECT_EQ(history().count(), 0);
  EXPECT_FALSE(find<QAction>("actionUndo")->isEnabled());
  EXPECT_FALSE(find<QAction>("actionRedo")->isEnabled());
  EXPECT_FALSE(window->isWindowModified());
}

TEST_F(History, ADragIsOneStep) {
  auto* slider = find<QSlider>("fapSlider3");
  const QPoint middle = slider->rect().center();
  QTest::mousePress(slider, Qt::LeftButton, Qt::NoModifier, middle);
  for (int i = 1; i <= 10; ++i) {
    dragTo(slider, middle + QPoint(3 * i, 0));
    settle();
  }
  EXPECT_EQ(history().count(), 0);
  QTest::mouseRelease(slider, Qt::LeftButton, Qt::NoModifier, middle + QPoint(30, 0));
  settle();
  EXPECT_EQ(history().count(), 1);
  EXPECT_EQ(undoText().toStdString(), "&Undo FAP 3");
  EXPECT_NE(window->model().state(), FaceState());
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  settle();
  EXPECT_EQ(window->model().state(), FaceState());
  EXPECT_EQ(slider->value(), 0);
  EXPECT_FALSE(window->isWindowModified());
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  settle();
  EXPECT_EQ(window->model().state().fapValues.size(), 1u);
  EXPECT_TRUE(window->isWindowModified());
}

TEST_F(History, AMirroredPairIsOneStep) {
  auto* number = find<QDoubleSpinBox>("fapValue31");
  number->setFocus();
  number->selectAll();
  QTest::keyClicks(number, "120\r");
  settle();
  EXPECT_EQ(window->model().state().fapValues, (std::map<int, double>{{31, 120.0}, {32, 120.0}}));
  EXPECT_EQ(undoText().toStdString(), "&Undo FAP 31, 32");
  QTest::keyClick(number, Qt::Key_Z, Qt::ControlModifier);
  settle();
  EXPECT_EQ(window->model().state(), FaceState());
}

TEST_F(History, TurningTheWheelIsOneStepAndClicksAreMany) {
  auto* scheme = find<QComboBox>("surfaceScheme");
  for (int i = 0; i < 3; ++i) wheel(scheme, 1);
  EXPECT_EQ(history().count(), 1);
  EXPECT_EQ(undoText().toStdString(), "&Undo scheme");
  auto* remainder = find<QCheckBox>("surfaceRemainder");
  for (int i = 0; i < 3; ++i) {
    QTest::mouseClick(remainder, Qt::LeftButton, Qt::NoModifier, {8, remainder->height() / 2});
    settle();
  }
  EXPECT_EQ(history().count(), 4);
  for (int i = 0; i < 4; ++i) history().undo();
  EXPECT_EQ(window->model().state(), FaceState());
}

TEST_F(History, PlayedFramesAreNoSteps) {
  ASSERT_TRUE(window->openFile(writeLids(40, 50.0)));
  history().clear();
  window->player().play();
  ASSERT_TRUE(waitUntil([this] { return window->model().frameIndex() > 8; }));
  window->player().pause();
  settle();
  history().record();
  EXPECT_EQ(history().count(), 0);
  EXPECT_FALSE(window->isWindowModified());
}

TEST_F(History, WhatIsDoneWhilePlayingIsUndoneWithoutTheFrames) {
  ASSERT_TRUE(window->openFile(writeLids(400, 50.0)));
  history().clear();
  window->player().play();
  ASSERT_TRUE(waitUntil([this] { return window->model().frameIndex() > 3; }));
  QTest::mouseClick(find<QToolButton>("curvePoints"), Qt::LeftButton);
  ASSERT_TRUE(waitUntil([this] { return window->model().frameIndex() > 10; }));
  EXPECT_EQ(history().count(), 1);
  EXPECT_EQ(undoText().toStdString(), "&Undo Points");
  history().undo();
  EXPECT_GT(window->model().frameIndex(), 9);
  EXPECT_TRUE(find<QToolButton>("curvePoints")->isChecked());
}

TEST_F(History, AScrubIsOneStep) {
  ASSERT_TRUE(window->openFile(writeLids(40, 50.0)));
  history().clear();
  auto* position = find<QSlider>("timelinePosition");
  QTest::mousePress(position, Qt::LeftButton, Qt::NoModifier, {30, position->height() / 2});
  for (int i = 1; i <= 5; ++i) dragTo(position, {30 + 10 * i, position->height() / 2});
  QTest::mouseRelease(position, Qt::LeftButton, Qt::NoModifier, {80, position->height() / 2});
  settle();
  EXPECT_EQ(history().count(), 1);
  EXPECT_EQ(undoText().toStdString(), "&Undo frame");
  history().undo();
  EXPECT_EQ(window->model().frameIndex(), 0);
}

TEST_F(History, SettingsOfADockAreUndoneByName) {
  auto* sampling = find<QComboBox>("vectorsSampling");
  touch();
  sampling->setCurrentIndex(1);
  settle();
  history().record();
  EXPECT_EQ(undoText().toStdString(), "&Undo Motion vectors: Sampling");
  history().undo();
  EXPECT_EQ(sampling->currentIndex(), 0);
  history().redo();
  EXPECT_EQ(sampling->currentIndex(), 1);
}

TEST_F(History, APinIsUndoneAndRedone) {
  auto* against = find<QComboBox>("vectorsAgainst");
  touch();
  find<QToolButton>("vectorsPin")->click();
  settle();
  history().record();
  EXPECT_EQ(history().count(), 1);
  EXPECT_EQ(against->currentIndex(), 2);
  history().undo();
  EXPECT_EQ(against->count(), 2);
  EXPECT_EQ(against->currentIndex(), 0);
  history().redo();
  EXPECT_EQ(against->count(), 3);
  EXPECT_EQ(against->currentIndex(), 2);
}

TEST_F(History, AComparisonIsUndoneAndRedone) {
  mien::Comparison* comparison = find<mien::ViewArea>("viewArea")->comparison();
  window->model().change([](FaceState& state) { state.expressions["joy"] = 0.7; });
  settle();
  history().clear();
  touch();
  comparison->pin();
  settle();
  history().record();
  EXPECT_EQ(undoText().toStdString(), "&Undo comparison");
  const json pinned = comparison->sessionState();
  touch();
  comparison->compareScheme("spline");
  settle();
  history().record();
  EXPECT_EQ(history().count(), 2);
  history().undo();
  EXPECT_EQ(comparison->sessionState(), pinned);
  history().undo();
  EXPECT_EQ(comparison->kind(), mien::Comparison::Kind::None);
  EXPECT_EQ(find<QComboBox>("colorBy")->currentText().toStdString(), "Skin");
  history().redo();
  EXPECT_EQ(comparison->sessionState(), pinned);
}

TEST_F(History, WhatIsTypedAtOnceIsOneStep) {
  find<QToolButton>("fapAll")->setChecked(true);
  touch();
  settle();
  history().clear();
  auto* search = find<QLineEdit>("fapSearch");
  search->setFocus();
  QTest::keyClicks(search, "brow");
  settle();
  EXPECT_EQ(history().count(), 1);
}

/// In the menu: neither its object's name nor that of a dock for all that is in it.
TEST_F(History, EverySettingHasANameOfItsOwn) {
  const json all = settings();
  std::string nameless;
  for (const auto& dock : all.items())
    for (const auto& setting : dock.value().items()) {
      const json change = {{"docks", {{dock.key(), {{setting.key(), 1}}}}}};
      const QString text = mien::changeText(change, *window);
      const bool isOwn = dock.key() == "window" ? text != "view" : text.contains(": ");
      if (!isOwn) nameless += dock.key() + "/" + setting.key() + " ";
    }
  EXPECT_EQ(nameless, "");
}

TEST_F(History, OpeningAnAnimationIsUndone) {
  touch();
  ASSERT_TRUE(window->openFile(writeLids(40, 50.0)));
  settle();
  history().record();
  EXPECT_EQ(undoText().toStdString(), "&Undo animation");
  history().undo();
  EXPECT_EQ(window->model().frameCount(), 0);
  history().redo();
  EXPECT_EQ(window->model().frameCount(), 40);
}

TEST_F(History, AStateThatIsRefusedIsNoStep) {
  touch();
  window->model().change([](FaceState& state) { state.curvesFile = "no/such/file.vtp"; });
  settle();
  history().record();
  EXPECT_EQ(history().count(), 0);
  EXPECT_NE(message(), "");
}

TEST_F(History, WhatIsTypedIntoATextIsUndoneThereFirst) {
  auto* search = find<QLineEdit>("fapSearch");
  find<QToolButton>("fapAll")->setChecked(true);
  search->setFocus();
  QTest::keyClicks(search, "brow");
  QTest::keyClick(search, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(search->text().toStdString(), "");
}

/// What a list has chosen that was filled in the background meanwhile is not what the user did.
json knownBefore(const json& now, const json& before) {
  json known = json::object();
  for (const auto& dock : now.items())
    for (const auto& setting : dock.value().items())
      if (before[dock.key()].contains(setting.key())) known[dock.key()][setting.key()] = setting.value();
  return known;
}

/// One act of a user who tries everything: a widget by chance, and a value near the present one.
class Walk {
 public:
  explicit Walk(mien::StudioWindow& window) : window_(window) {
    const json all = WidgetSettings::read(window, WidgetSettings::Of::Undo);
    for (const auto& dock : all.items())
      for (const auto& setting : dock.value().items()) {
        auto* widget =
            qobject_cast<QWidget*>(const_cast<QObject*>(WidgetSettings::find(window, dock.key(), setting.key())));
        if (widget && widget->objectName() != "textureOn") widgets_.push_back(widget);
      }
  }

  size_t choices() const { return widgets_.size(); }

  void step() {
    const int what = pick(22);
    if (what == 0) return change([](FaceState& state) { state.fapValues.clear(); });
    if (what == 1) return edit();
    if (what == 2) return window_.findChild<QToolButton*>(pick(3) ? "vectorsPin" : "deformationPin")->click();
    if (what == 3) return window_.findChild<QToolButton*>("vectorsUnpin")->click();
    if (what == 4)
      return change([this](FaceState& state) { state.surface.smoothing[pick(9)] = 0.1 + 0.013 * pick(99); });
    if (what == 5) return window_.findChild<QPushButton*>("surfaceReset")->click();
    if (what == 6) return compare();
    change(widgets_[pick(static_cast<int>(widgets_.size()))]);
  }

 private:
  int pick(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }

  template <class Edit>
  void change(const Edit& edit) {
    window_.model().change(edit);
  }

  void edit() {
    change([this](FaceState& state) {
      mien::CurveEdit edit = mien::CurveEdit::ofPoint(2 + pick(24), pick(40), 40);
      edit.move.z() = 0.05 * (pick(21) - 10) + 1e-3;
      state.edits.size() > 3 ? state.edits.clear() : state.edits.push_back(edit);
    });
  }

  void compare() {
    mien::Comparison* comparison = window_.findChild<mien::ViewArea*>("viewArea")->comparison();
    const auto& schemes = mien::faceSchemes();
    const int what = pick(4);
    if (what == 0) comparison->clear();
    if (what == 1) comparison->pin();
    if (what == 2) comparison->compareScheme(QString::fromStdString(schemes[pick(int(schemes.size()))].name));
    if (what == 3) comparison->swap();
    if (auto* other = window_.findChild<QWidget*>("otherFaceView")) other->setUpdatesEnabled(false);
  }

  /// A separator cannot be chosen by hand.
  static void choose(QComboBox* list, int row) {
    if (!list->itemText(row).isEmpty()) list->setCurrentIndex(row);
  }

  void change(QWidget* widget) {
    if (auto* list = qobject_cast<QComboBox*>(widget)) return choose(list, pick(list->count()));
    if (auto* whole = qobject_cast<QSpinBox*>(widget)) return whole->setValue(whole->value() + pick(9) - 4);
    if (auto* number = qobject_cast<QDoubleSpinBox*>(widget))
      return number->setValue(number->value() + 0.37 * (pick(9) - 4));
    if (auto* slider = qobject_cast<QSlider*>(widget)) return slider->setValue(slider->value() + pick(61) - 30);
    if (auto* button = qobject_cast<QAbstractButton*>(widget)) button->click();
  }

  mien::StudioWindow& window_;
  std::vector<QWidget*> widgets_;
  std::mt19937 random_{20260};
};

TEST_F(History, OfARandomWalkLeadsBackBitForBit) {
  constexpr int steps = 500;
  window->setUpdatesEnabled(false);  // what is drawn is no part of what is compared
  Walk walk(*window);
  ASSERT_GT(walk.choices(), 150u);
  std::vector<std::string> states = {state()};
  std::vector<json> all = {settings()};
  int tries = 0;
  while (history().count() < steps && ++tries < 4 * steps) {
    touch();
    walk.step();
    settle();
    history().record();
    if (history().count() == static_cast<int>(states.size()) - 1) continue;
    ASSERT_EQ(history().count(), static_cast<int>(states.size()));
    states.push_back(state());
    all.push_back(settings());
  }
  ASSERT_EQ(history().count(), steps) << "after " << tries << " tries";
  for (int i = steps - 1; i >= 0; --i) {
    history().undo();
    ASSERT_EQ(state(), states[i]) << "step " << i;
    ASSERT_EQ(json::diff(knownBefore(settings(), all[i]), all[i]).dump(), "[]") << "step " << i;
  }
  EXPECT_EQ(window->model().state(), FaceState());
  EXPECT_FALSE(window->isWindowModified());
  for (int i = 1; i <= steps; ++i) history().redo();
  EXPECT_EQ(state(), states.back());
  EXPECT_EQ(json::diff(knownBefore(settings(), all.back()), all.back()).dump(), "[]");
  EXPECT_EQ(history().count(), steps);
}

}  // namespace
