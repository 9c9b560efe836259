#include <QAction>
#include <QComboBox>
#include <QPushButton>
#include <QSpinBox>
#include <cmath>

#include "FaceModel.h"
#include "StudioFixture.h"
#include "ValueSlider.h"

namespace {

using ExpressionPanel = StudioFixture;

TEST_F(ExpressionPanel, EachOfTheSixMovesTheFaceAndIsSeen) {
  const QImage neutral = find<QWidget>("faceView")->grab().toImage();
  for (const char* name : {"joy", "sadness", "anger", "fear", "disgust", "surprise"}) {
    auto* button = find<QPushButton>(QString("expression_") + name);
    EXPECT_FALSE(button->toolTip().isEmpty());
    QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_TRUE(button->isChecked());
    EXPECT_EQ(window->model().state().expressions.count(name), 1u);
    EXPECT_GT(largestDisplacement(), 1.0) << name;
    EXPECT_NE(find<QWidget>("faceView")->grab().toImage(), neutral) << name;
  }
}

TEST_F(ExpressionPanel, OneButtonIsDownAndASecondClickLetsItUp) {
  auto* joy = find<QPushButton>("expression_joy");
  auto* anger = find<QPushButton>("expression_anger");
  joy->click();
  anger->click();
  EXPECT_FALSE(joy->isChecked());
  EXPECT_TRUE(anger->isChecked());
  anger->click();
  EXPECT_FALSE(anger->isChecked());
  EXPECT_EQ(largestDisplacement(), 0.0);
}

TEST_F(ExpressionPanel, IntensityWeakensIt) {
  QTest::keyClick(find<QPushButton>("expression_joy"), Qt::Key_Space);
  const double full = largestDisplacement();
  auto* percent = find<QSpinBox>("expressionPercent_joy");
  percent->selectAll();
  QTest::keyClicks(percent, "50");
  const double half = largestDisplacement();
  EXPECT_EQ(window->model().state().expressions.at("joy"), 0.5);
  EXPECT_GT(half, 0.2 * full);
  EXPECT_LT(half, 0.8 * full);
  EXPECT_EQ(find<mien::ValueSlider>("expressionSlider_joy")->value(), 50);
}

TEST_F(ExpressionPanel, SlidersMixAndTheFAPsAddUp) {
  const auto shown = [this](int fap) {
    settle();
    return window->model().shownFAP(fap);
  };
  find<QSpinBox>("expressionPercent_joy")->setValue(60);
  const double joy53 = shown(53), joy33 = shown(33);
  find<mien::ValueSlider>("expressionSlider_joy")->setValue(0);
  EXPECT_TRUE(window->model().state().expressions.empty());
  find<mien::ValueSlider>("expressionSlider_surprise")->setValue(40);
  const double surprise53 = shown(53), surprise33 = shown(33);
  find<mien::ValueSlider>("expressionSlider_joy")->setValue(60);
  EXPECT_EQ(window->model().state().expressions, (std::map<std::string, double>{{"joy", 0.6}, {"surprise", 0.4}}));
  EXPECT_NEAR(shown(53), joy53 + surprise53, 1e-9);
  EXPECT_NEAR(shown(33), joy33 + surprise33, 1e-9);
  EXPECT_GT(std::abs(joy53), 10.0);
  EXPECT_GT(std::abs(surprise33), 10.0);
  EXPECT_TRUE(find<QPushButton>("expression_joy")->isChecked());
  EXPECT_TRUE(find<QPushButton>("expression_surprise")->isChecked());
  find<QPushButton>("expression_anger")->click();
  EXPECT_EQ(window->model().state().expressions, (std::map<std::string, double>{{"anger", 1.0}}))
      << "a name chooses it alone";
  EXPECT_EQ(find<QSpinBox>("expressionPercent_joy")->value(), 0);
}

/// As a user would, in the list of a row.
void chooseViseme(QComboBox* row, const QString& name) {
  row->setCurrentIndex(row->findData(name));
  emit row->activated(row->currentIndex());
}

TEST_F(ExpressionPanel, EachVisemeHasWordsAndMovesTheMouth) {
  auto* first = find<QComboBox>("visemeName1");
  ASSERT_EQ(first->count(), 15);
  EXPECT_FALSE(find<mien::ValueSlider>("visemeSlider1")->isEnabled());
  for (int i = 1; i < first->count(); ++i) {
    EXPECT_TRUE(first->itemText(i).contains('(')) << i;
    EXPECT_FALSE(first->itemData(i, Qt::ToolTipRole).toString().isEmpty()) << i;
    chooseViseme(first, first->itemData(i).toString());
    EXPECT_EQ(window->model().state().visemes,
              (std::map<std::string, double>{{first->itemData(i).toString().toStdString(), 1.0}}));
    ASSERT_TRUE(window->model().update());
    EXPECT_GT(largestMovement(), 0.1) << i;
  }
  EXPECT_EQ(find<QSpinBox>("visemePercent1")->value(), 100);
  first->setCurrentIndex(0);
  emit first->activated(0);
  EXPECT_TRUE(window->model().state().visemes.empty());
}

TEST_F(ExpressionPanel, ASecondVisemeSharesAndSlidersMix) {
  auto *first = find<QComboBox>("visemeName1"), *second = find<QComboBox>("visemeName2");
  chooseViseme(first, "A");
  chooseViseme(second, "p b m");
  using Mixture = std::map<std::string, double>;
  EXPECT_EQ(window->model().state().visemes, (Mixture{{"A", 0.5}, {"p b m", 0.5}}));
  find<mien::ValueSlider>("visemeSlider2")->setValue(20);
  EXPECT_EQ(window->model().state().visemes, (Mixture{{"A", 0.5}, {"p b m", 0.2}}));
  chooseViseme(second, "A");
  EXPECT_EQ(first->currentData().toString(), "p b m") << "they change places";
  EXPECT_EQ(window->model().state().visemes, (Mixture{{"A", 0.5}, {"p b m", 0.2}}));
  find<QSpinBox>("visemePercent1")->setValue(0);
  EXPECT_EQ(window->model().state().visemes, (Mixture{{"A", 0.5}}));
  EXPECT_EQ(first->currentData().toString(), "p b m") << "the row keeps its viseme";
  find<QPushButton>("expression_joy")->click();
  EXPECT_EQ(window->model().state().visemes.size(), 1u) << "an expression goes with speech";
  const double jaw = window->model().shownFAP(3);
  EXPECT_NE(jaw, 0.0);
  find<QAction>("actionNeutral")->trigger();
  EXPECT_TRUE(window->model().state().visemes.empty());
  EXPECT_EQ(first->currentIndex(), 0);
  EXPECT_EQ(second->currentIndex(), 0);
  window->model().change([](mien::FaceState& state) { state.visemes = {{"U", 0.25}}; });
  EXPECT_EQ(first->currentData().toString(), "U");
  EXPECT_EQ(find<QSpinBox>("visemePercent1")->value(), 25);
}

TEST_F(ExpressionPanel, TheFAPSlidersShowWhereAnExpressionTakesTheFace) {
  find<QPushButton>("expression_surprise")->click();
  settle();
  auto* slider = find<mien::ValueSlider>("fapSlider33");
  EXPECT_EQ(slider->value(), 0);
  EXPECT_GT(std::abs(slider->shownValue()), 10.0);
}

}  // namespace
