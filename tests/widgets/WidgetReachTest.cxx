#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QSpinBox>
#include <QTabBar>
#include <cmath>
#include <map>

#include "StudioFixture.h"
#include "Theme.h"

namespace {

using WidgetReach = StudioFixture;

template <class... Classes>
bool isOneOf(const QObject* object) {
  return (qobject_cast<const Classes*>(object) || ...);
}

bool isInput(const QWidget* widget) {
  if (widget->objectName().isEmpty() || widget->objectName().startsWith("qt_")) return false;
  if (isOneOf<QScrollBar>(widget) || isOneOf<QTabBar>(widget->parentWidget())) return false;
  return isOneOf<QAbstractButton, QComboBox, QAbstractSpinBox, QAbstractSlider, QLineEdit, QTabBar, QAbstractItemView,
                 QPlainTextEdit>(widget);
}

std::vector<QWidget*> inputsOf(const QWidget& window) {
  std::vector<QWidget*> inputs;
  for (auto* widget : window.findChildren<QWidget*>())
    if (isInput(widget)) inputs.push_back(widget);
  return inputs;
}

QString toolTipOf(const QWidget* widget) {
  const auto* tabs = qobject_cast<const QTabBar*>(widget);
  return tabs && tabs->toolTip().isEmpty() ? tabs->tabToolTip(0) : widget->toolTip();
}

bool hasMnemonic(const QWidget* widget) {
  const auto* button = qobject_cast<const QAbstractButton*>(widget);
  return button && !button->shortcut().isEmpty();
}

TEST_F(WidgetReach, EveryInputHasATooltipAndCanHaveTheFocus) {
  const auto inputs = inputsOf(*window);
  EXPECT_GT(inputs.size(), 200u);
  for (const QWidget* input : inputs) {
    const std::string name = input->objectName().toStdString();
    EXPECT_FALSE(toolTipOf(input).isEmpty()) << name;
    EXPECT_TRUE((input->focusPolicy() & Qt::TabFocus) || hasMnemonic(input)) << name;
  }
}

TEST_F(WidgetReach, ALabelTellsWhatItsInputTells) {
  int count = 0;
  for (const auto* label : window->findChildren<QLabel*>()) {
    if (!label->buddy()) continue;
    ++count;
    EXPECT_EQ(label->toolTip(), label->buddy()->toolTip()) << label->text().toStdString();
  }
  EXPECT_GT(count, 15);
}

/// A number without a unit behind it says in its tooltip what it counts, or that it has none.
TEST_F(WidgetReach, EveryNumberTellsItsUnit) {
  for (const auto* number : window->findChildren<QDoubleSpinBox*>()) {
    const QString text = number->suffix() + number->prefix() + number->toolTip();
    bool tells = false;
    for (const char* unit : {"mm", "\u00b0", "unit", "%", "degrees", "rad"})
      tells = tells || text.contains(QString::fromUtf8(unit));
    EXPECT_TRUE(tells) << number->objectName().toStdString() << ": " << text.toStdString();
  }
}

TEST_F(WidgetReach, TabReachesEveryInputThatIsSeen) {
  QApplication::setActiveWindow(window.get());
  for (int workspace = 1; workspace <= 4; ++workspace) {
    find<QAction>(QString("actionWorkspace%1").arg(workspace))->trigger();
    settle();
    find<QWidget>("surfaceScheme")->setFocus();
    find<QWidget>("expression_joy")->setFocus();
    std::set<const QWidget*> reached;
    for (int i = 0; i < 400 && QApplication::focusWidget(); ++i) {
      reached.insert(QApplication::focusWidget());
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    }
    EXPECT_GT(reached.size(), 30u);
    for (const QWidget* input : inputsOf(*window)) {
      const bool seen = input->isVisible() && input->isEnabled() && !input->visibleRegion().isEmpty();
      const bool isInside = input->focusProxy() || hasMnemonic(input);
      if (seen && !isInside) {
        EXPECT_TRUE(reached.count(input)) << workspace << " " << input->objectName().toStdString();
      }
    }
  }
}

using Uses = std::map<std::string, std::vector<std::string>>;

void expectOnce(const Uses& uses, const std::string& scope) {
  for (const auto& [keys, users] : uses) {
    std::string all;
    for (const std::string& user : users) all += " '" + user + "'";
    EXPECT_EQ(users.size(), 1u) << scope << ": " << keys << " is taken by" << all;
  }
}

void note(Uses& uses, const QKeySequence& keys, const QString& user) {
  if (!keys.isEmpty()) uses[keys.toString().toStdString()].push_back(user.toStdString());
}

void expectClearMenu(const QMenu& menu) {
  Uses uses;
  for (const QAction* action : menu.actions()) {
    note(uses, QKeySequence::mnemonic(action->text()), action->text());
    if (action->menu()) expectClearMenu(*action->menu());
  }
  expectOnce(uses, menu.title().toStdString());
}

double luminance(const QColor& color) {
  const auto linear = [](double x) { return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}

/// Of two colours, as WCAG 2.1 defines it.
double contrastOf(const QColor& one, const QColor& other) {
  const double a = luminance(one), b = luminance(other);
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

/// The best contrast to the window that a pixel of the widget's left edge has, half way down.
double edgeContrast(QWidget& widget) {
  const QImage picture = widget.grab().toImage();
  double best = 1.0;
  for (int x = 0; x < 5; ++x)
    best = std::max(best, contrastOf(picture.pixelColor(x, picture.height() / 2), mien::Theme::current().window));
  return best;
}

/// WCAG 2.1 asks for 3:1 of what shows that there is something to press or to fill in.
TEST_F(WidgetReach, BoxesAndFieldsHaveAnEdge) {
  for (mien::Theme::Kind kind : {mien::Theme::Kind::Dark, mien::Theme::Kind::Light}) {
    mien::Theme::apply(kind, *qApp);
    QCheckBox box("box");
    QLineEdit field;
    QSpinBox number;
    QComboBox list;
    for (QWidget* widget : std::initializer_list<QWidget*>{&box, &field, &number, &list}) {
      widget->show();
      settle();
      EXPECT_GE(edgeContrast(*widget), 3.0) << widget->metaObject()->className() << ", theme " << int(kind);
    }
  }
}

/// As much for the handle of a scroll bar in its groove.
TEST_F(WidgetReach, TheHandleOfAScrollBarIsSeen) {
  for (mien::Theme::Kind kind : {mien::Theme::Kind::Dark, mien::Theme::Kind::Light}) {
    mien::Theme::apply(kind, *qApp);
    for (Qt::Orientation orientation : {Qt::Vertical, Qt::Horizontal}) {
      QScrollBar bar(orientation);
      bar.setRange(0, 100);
      bar.setPageStep(100);  // half of it
      bar.resize(orientation == Qt::Vertical ? QSize(bar.sizeHint().width(), 200)
                                             : QSize(200, bar.sizeHint().height()));
      bar.show();
      settle();
      const QImage picture = bar.grab().toImage();
      const QPoint middle = picture.rect().center();
      const QPoint along = orientation == Qt::Vertical ? QPoint(0, 50) : QPoint(50, 0);
      EXPECT_GE(contrastOf(picture.pixelColor(middle - along), picture.pixelColor(middle + along)), 3.0) << int(kind);
    }
  }
}

/// Above the round corner of a box of a number there is nothing.
TEST_F(WidgetReach, ABoxOfANumberHasCornersOfOneColor) {
  for (auto symbols : {QAbstractSpinBox::NoButtons, QAbstractSpinBox::UpDownArrows}) {
    QSpinBox number;
    number.setButtonSymbols(symbols);
    number.show();
    settle();
    const QImage picture = number.grab().toImage();
    EXPECT_EQ(picture.pixelColor(0, 0), picture.pixelColor(picture.width() - 1, 0)) << symbols;
  }
}

/// A ring of two pixels, on buttons that are flat, framed, or on.
TEST_F(WidgetReach, AButtonWithTheFocusHasARing) {
  QApplication::setActiveWindow(window.get());
  for (const char* name : {"lookFront", "curvePoints", "curveHead", "surfaceReset", "expression_joy"}) {
    auto* button = find<QAbstractButton>(name);
    window->setFocus();
    settle();
    const QImage before = button->grab().toImage();
    button->setFocus();
    settle();
    const QImage after = button->grab().toImage();
    ASSERT_EQ(after.size(), before.size());
    const int middle = after.height() / 2;
    for (int x : {0, 1, after.width() - 2, after.width() - 1}) {
      const QColor ring = after.pixelColor(x, middle), inside = after.pixelColor(4, middle);
      const double contrast = std::abs(qGray(ring.rgb()) - qGray(inside.rgb()));
      EXPECT_GT(contrast, 60.0) << name << " at " << x;
    }
    EXPECT_EQ(after.pixelColor(4, middle), before.pixelColor(4, middle)) << name;
  }
}

/// In the rows above the views.
TEST_F(WidgetReach, TabGoesFromLeftToRight) {
  for (const char* first : {"faceCurves", "faceMesh", "curvePoints"}) {
    auto* begin = find<QWidget>(first);
    const int top = begin->mapTo(window.get(), begin->rect().center()).y();
    int right = -1, count = 0;
    QWidget* widget = begin;
    do {
      const QPoint at = widget->mapTo(window.get(), widget->rect().center());
      const bool isInRow = isInput(widget) && widget->isVisible() && std::abs(at.y() - top) < 8 &&
                           (widget->parentWidget() == begin->parentWidget() || first == std::string("faceCurves"));
      if (isInRow) {
        EXPECT_GT(at.x(), right) << widget->objectName().toStdString();
        right = at.x();
        ++count;
      }
      widget = widget->nextInFocusChain();
    } while (widget != begin);
    EXPECT_GE(count, 4) << first;
  }
}

/// Views that jump cannot be compared by eye.
TEST_F(WidgetReach, ChoosingAColouringMovesNoView) {
  auto* view = find<QWidget>("faceView");
  auto* row = find<QWidget>("coloringBar");
  for (int width : {1280, 1366, 1920}) {
    window->resize(width, 800);
    settle();
    find<QComboBox>("colorBy")->setCurrentText("Skin");
    settle();
    const QPoint before = view->mapTo(window.get(), QPoint());
    const int compared = find<QWidget>("compareWith")->mapTo(window.get(), QPoint()).y();
    EXPECT_LT(std::abs(compared - row->mapTo(window.get(), QPoint()).y()), 8) << "one row at " << width;
    find<QComboBox>("colorBy")->setCurrentText("Curvature \u03ba1 (1/mm)");
    settle();
    EXPECT_TRUE(find<QWidget>("colorEnd")->isVisible());
    EXPECT_EQ(view->mapTo(window.get(), QPoint()), before) << width;
  }
}

/// Every entry stands below a heading, and does what the window's button or list does.
TEST_F(WidgetReach, TheViewMenuHasSections) {
  auto* menu = find<QMenu>("viewMenu");
  QStringList headings;
  ASSERT_TRUE(menu->actions().front()->isSeparator());
  for (const QAction* action : menu->actions())
    if (action->isSeparator()) headings << action->text();
  EXPECT_EQ(headings, QStringList({"Camera", "Face", "Curves", "Workspace and docks", "Pictures", "Window"}));
  EXPECT_LE(menu->sizeHint().height(), 600) << "in the smallest window too";
  const auto entry = [&](QMenu* of, const QString& text) {
    emit of->aboutToShow();
    for (QAction* action : of->actions())
      if (action->text().remove('&') == text) return action;
    return static_cast<QAction*>(nullptr);
  };
  auto* wireframe = entry(find<QMenu>("drawingMenu"), "Wireframe");
  ASSERT_TRUE(wireframe);
  wireframe->trigger();
  EXPECT_EQ(find<QComboBox>("faceMesh")->currentText(), "Wireframe");
  EXPECT_TRUE(entry(find<QMenu>("drawingMenu"), "Wireframe")->isChecked());
  auto* names = entry(menu, "Names beside the face");
  ASSERT_TRUE(names);
  EXPECT_FALSE(names->isChecked());
  names->trigger();
  EXPECT_TRUE(find<QAbstractButton>("faceCurveNames")->isChecked());
  EXPECT_TRUE(entry(menu, "Names beside the face")->isChecked());
}

/// Also in dark colours.
TEST_F(WidgetReach, ButtonsOfDocksCanBeSeen) {
  for (mien::Theme::Kind kind : {mien::Theme::Kind::Dark, mien::Theme::Kind::Light}) {
    mien::Theme::apply(kind, *qApp);
    settle();
    int buttons = 0;
    for (auto* button :
         find<QDockWidget>("fapDock")->findChildren<QAbstractButton*>(QString(), Qt::FindDirectChildrenOnly)) {
      if (!button->isVisible()) continue;
      const QImage image = button->grab().toImage();
      int darkest = 255, lightest = 0;
      for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
          darkest = std::min(darkest, qGray(image.pixel(x, y)));
          lightest = std::max(lightest, qGray(image.pixel(x, y)));
        }
      EXPECT_GT(lightest - darkest, 140) << button->objectName().toStdString();
      ++buttons;
    }
    EXPECT_EQ(buttons, 2) << "one detaches, one closes";
  }
}

/// Flat, as all else: one colour from top to bottom.
TEST_F(WidgetReach, ListsHaveNoGradient) {
  for (mien::Theme::Kind kind : {mien::Theme::Kind::Dark, mien::Theme::Kind::Light}) {
    mien::Theme::apply(kind, *qApp);
    settle();
    auto* list = find<QComboBox>("faceMesh");
    const QImage image = list->grab().toImage();
    const QColor inside = mien::Theme::current().panel;
    for (int y = 3; y < image.height() - 3; ++y) EXPECT_EQ(image.pixelColor(4, y), inside) << y;
  }
}

TEST_F(WidgetReach, NoTwoMenuEntriesHaveOneLetter) {
  for (const QAction* action : window->menuBar()->actions())
    if (action->menu()) expectClearMenu(*action->menu());
}

TEST_F(WidgetReach, NoKeysHaveTwoMeanings) {
  Uses uses;
  for (const QAction* action : window->menuBar()->actions())
    note(uses, QKeySequence::mnemonic(action->text()), action->text());
  for (const auto* action : window->findChildren<QAction*>())
    if (action->shortcutContext() != Qt::WidgetShortcut && action->shortcutContext() != Qt::WidgetWithChildrenShortcut)
      for (const QKeySequence& keys : action->shortcuts()) note(uses, keys, action->text());
  for (const auto* button : window->findChildren<QAbstractButton*>())
    note(uses, button->shortcut(), button->objectName() + ' ' + button->text());
  for (const auto* label : window->findChildren<QLabel*>())
    if (label->buddy()) note(uses, QKeySequence::mnemonic(label->text()), label->text());
  expectOnce(uses, "the window");
}

}  // namespace
