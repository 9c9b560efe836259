#include <QAbstractButton>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDrag>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QPointer>
#include <QTabBar>
#include <QTimer>
#include <QWheelEvent>
#include <functional>
#include <iostream>
#include <random>

#include "FaceModel.h"
#include "History.h"
#include "MessageBar.h"
#include "StudioFixture.h"

namespace {

constexpr int actions = 2000;
constexpr int actionsDrawn =
    4;  // of the window a picture is made after so many: without a graphics card it takes longest
constexpr int mostPoints = 20000;  // of the mesh: a user who waits is not what is tried

/// Of MIEN_RANDOM_SEED, for other walks than the usual one.
unsigned seed() {
  return qEnvironmentVariableIsSet("MIEN_RANDOM_SEED") ? qEnvironmentVariableIntValue("MIEN_RANDOM_SEED") : 20110829;
}

/// Clicks, drags, wheels and types at random over a whole window, as a cat on the keyboard and a child with the mouse.
/// Files are never chosen: whatever dialog asks for one is closed.
class Monkey {
 public:
  explicit Monkey(mien::StudioWindow& window) : window_(window), random_(seed()) {
    QObject::connect(&watcher_, &QTimer::timeout, [] {
      if (QWidget* popup = QApplication::activePopupWidget())
        popup->close();
      else if (QWidget* dialog = QApplication::activeModalWidget())
        dialog->close();
      else
        QDrag::cancel();  // of text: it waits for a button of the display to be let go, which nobody presses
    });
    watcher_.start(15);
  }

  void act() {
    QWidget* target = below(10) < 7 ? input() : anywhere();
    if (!target) return;
    tell(target);
    const QPoint at(below(std::max(1, target->width())), below(std::max(1, target->height())));
    switch (below(8)) {
      case 0:
      case 1:
      case 2:
        return QTest::mouseClick(target, button(), modifiers(), at);
      case 3:
        return QTest::mouseDClick(target, Qt::LeftButton, Qt::NoModifier, at);
      case 4:
        return drag(target, at);
      case 5:
        return wheel(target, at);
      default:
        return type(target);
    }
  }

 private:
  /// Where a walk was that did not come to its end.
  void tell(const QWidget* target) {
    std::cout << ++acts_ << ' ' << target->metaObject()->className() << ' ' << qPrintable(target->objectName())
              << std::endl;
  }

  int below(int end) { return std::uniform_int_distribution<int>(0, end - 1)(random_); }
  Qt::MouseButton button() { return below(6) ? Qt::LeftButton : Qt::RightButton; }
  Qt::KeyboardModifiers modifiers() {
    const Qt::KeyboardModifiers all[] = {Qt::NoModifier, Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier};
    return all[below(4)];
  }

  QWidget* input() {
    return usable([](const QWidget* widget) {
      return qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QComboBox*>(widget) ||
             qobject_cast<const QAbstractSpinBox*>(widget) || qobject_cast<const QAbstractSlider*>(widget) ||
             qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QTabBar*>(widget);
    });
  }

  QWidget* anywhere() {
    return usable([](const QWidget*) { return true; });
  }

  /// Any of those that can be used, each as likely as the other: what is seen of a widget takes long to find out, so
  /// only those are asked that chance has chosen.
  QWidget* usable(const std::function<bool(const QWidget*)>& isWanted) {
    QList<QWidget*> all;
    for (auto* widget : window_.findChildren<QWidget*>())
      if (widget->isVisible() && widget->isEnabled() && isWanted(widget)) all << widget;
    while (!all.isEmpty()) {
      const int chosen = below(all.size());
      if (!all[chosen]->visibleRegion().isEmpty()) return all[chosen];
      all.removeAt(chosen);
    }
    return nullptr;
  }

  void drag(QWidget* target, const QPoint& from) {
    const QPointer<QWidget> still(target);
    QTest::mousePress(target, Qt::LeftButton, modifiers(), from);
    for (int i = 0; i < 3 && still; ++i) {
      const QPoint to(below(std::max(1, target->width())), below(std::max(1, target->height())));
      QMouseEvent move(QEvent::MouseMove, to, target->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
      QApplication::sendEvent(target, &move);
    }
    if (still) QTest::mouseRelease(target, Qt::LeftButton, Qt::NoModifier, from);
  }

  void wheel(QWidget* target, const QPoint& at) {
    const QPoint turn(0, below(2) ? 120 : -120);
    QWheelEvent event(at, target->mapToGlobal(at), QPoint(), turn, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(target, &event);
  }

  void type(QWidget* target) {
    static const int keys[] = {Qt::Key_Tab, Qt::Key_Backtab, Qt::Key_Escape, Qt::Key_Return,   Qt::Key_Space,
                               Qt::Key_Up,  Qt::Key_Down,    Qt::Key_Left,   Qt::Key_Right,    Qt::Key_Home,
                               Qt::Key_End, Qt::Key_PageUp,  Qt::Key_Delete, Qt::Key_PageDown, Qt::Key_Backspace,
                               Qt::Key_0,   Qt::Key_1,       Qt::Key_5,      Qt::Key_Minus,    Qt::Key_Period,
                               Qt::Key_A,   Qt::Key_E,       Qt::Key_W,      Qt::Key_S,        Qt::Key_P,
                               Qt::Key_Z,   Qt::Key_F2,      Qt::Key_F3,     Qt::Key_F4,       Qt::Key_3};
    const auto key = static_cast<Qt::Key>(keys[below(std::size(keys))]);
    QTest::keyClick(below(2) ? target : static_cast<QWidget*>(&window_), key, modifiers());
  }

  mien::StudioWindow& window_;
  std::mt19937 random_;
  QTimer watcher_;
  int acts_ = 0;
};

class RandomInput : public StudioFixture {
 protected:
  /// Meshes of millions of points only make it slow.
  void keepSmall() {
    const mien::FaceState& state = window->model().state();
    if (state.rows * state.columns <= mostPoints) return;
    window->model().change([](mien::FaceState& changed) {
      changed.rows = mien::FaceState().rows;
      changed.columns = mien::FaceState().columns;
    });
  }
};

TEST_F(RandomInput, TwoThousandClicksAndKeysLeaveAWindowThatWorks) {
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  QApplication::setActiveWindow(window.get());
  window->resize(960, 660);  // in which buttons wait in panels as well
  settle();
  Monkey monkey(*window);
  for (int i = 0; i < actions; ++i) {
    monkey.act();
    keepSmall();
    window->setUpdatesEnabled(i % actionsDrawn == 0);
    settle();
    if (!window->isVisible()) window->show();  // it was closed
  }
  ASSERT_TRUE(QTest::qWaitFor([] { return !QApplication::activeModalWidget(); }, 20000));
  window->setUpdatesEnabled(true);
  window->history().record();
  EXPECT_GT(window->history().count(), 50) << "it did something";
  find<QAction>("actionNeutral")->trigger();
  window->model().change([](mien::FaceState& state) { state = mien::FaceState(); });
  settle();
  EXPECT_EQ(window->model().state(), mien::FaceState());
  EXPECT_EQ(largestDisplacement(), 0.0);
  EXPECT_GT(colorsIn("faceView"), 200);
}

/// It was seen once to wait for ever.
TEST_F(RandomInput, SelectedTextThatIsDraggedDoesNotHoldTheWalk) {
  find<mien::MessageBar>("messageBar")->showError("face.vtp: line 3: 'x' is not a number; write one", "");
  settle();
  auto* sentence = find<QLabel>("messageSentence");
  const Monkey monkey(*window);
  const QPoint word = sentence->contentsRect().topLeft() + QPoint(10, 8);
  QTest::mouseDClick(sentence, Qt::LeftButton, Qt::NoModifier, word);
  ASSERT_TRUE(sentence->hasSelectedText());
  QTest::qWait(QApplication::doubleClickInterval() + 100);  // a third click would choose all of it
  drag(sentence, word, {100, 0});
  EXPECT_EQ(sentence->text().left(8), "face.vtp");
}

}  // namespace
