#include <QApplication>
#include <QDoubleSpinBox>

#include "FaceModel.h"
#include "History.h"
#include "StudioFixture.h"

namespace {

/// What is done with keys alone, by one whose hands stay where they are.
class HistoryKeys : public StudioFixture {
 protected:
  HistoryKeys() { QApplication::setActiveWindow(window.get()); }  // for shortcuts; there is no window manager

  const mien::FaceState& state() { return window->model().state(); }
  bool stands(double value) {
    return waitUntil([&] { return fap() == value; });
  }
  double fap() const {
    const auto& values = window->model().state().fapValues;
    return values.count(31) ? values.at(31) : 0.0;
  }

  /// With the focus where the number was typed.
  void type(const QString& number) {
    auto* box = find<QDoubleSpinBox>("fapValue31");
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, number);
    QTest::keyClick(box, Qt::Key_Return);
    settle();
    ASSERT_TRUE(stands(number.toDouble()));
    rest();
  }
  /// As long as somebody looks at what came of it.
  void rest() { QTest::qWait(700); }
  void press(int key, Qt::KeyboardModifiers modifiers) {
    QTest::keyClick(QApplication::focusWidget(), key, modifiers);
    settle();
  }
};

TEST_F(HistoryKeys, TheNeutralFaceIsAStepOfItsOwn) {
  type("120");
  const mien::FaceState before = state();
  press(Qt::Key_0, Qt::ControlModifier);
  ASSERT_TRUE(stands(0.0));
  rest();
  EXPECT_EQ(window->history().count(), 2);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(state(), before);
}

/// Nor does it belong to what was typed just before.
TEST_F(HistoryKeys, EvenRightAfterTyping) {
  auto* box = find<QDoubleSpinBox>("fapValue31");
  box->setFocus();
  box->selectAll();
  QTest::keyClicks(box, "120");
  QTest::keyClick(box, Qt::Key_Return);
  const mien::FaceState before = state();
  press(Qt::Key_0, Qt::ControlModifier);
  ASSERT_TRUE(stands(0.0));
  rest();
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(state(), before);
}

/// Its button is shown pressed first, and acts 100 ms later.
TEST_F(HistoryKeys, AButtonsLetterIsAStepOfItsOwn) {
  type("120");
  const mien::FaceState before = state();
  press(Qt::Key_T, Qt::AltModifier);
  ASSERT_TRUE(stands(0.0)) << "Reset all FAPs has another letter";
  rest();
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(state(), before);
}

/// A key that is held acts on a button when it is released.
TEST_F(HistoryKeys, TheSpaceBarIsAStepOfItsOwn) {
  type("120");
  const mien::FaceState before = state();
  auto* joy = find<QWidget>("expression_joy");
  joy->setFocus();
  QTest::keyPress(joy, Qt::Key_Space);
  rest();
  QTest::keyRelease(joy, Qt::Key_Space);
  settle();
  rest();
  ASSERT_NE(state(), before);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(state(), before);
}

}  // namespace
