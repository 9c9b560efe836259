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

TEST_F(ExpressionPanel, TheFAPSlidersShowWhereAnExpressionTakesTheFace) {
  find<QPushButton>("expression_surprise")->click();
  settle();
  auto* slider = find<mien::ValueSlider>("fapSlider33");
  EXPECT_EQ(slider->value(), 0);
  EXPECT_GT(std::abs(slider->shownValue()), 10.0);
}

}  // namespace
