#include "FaceModel.h"
#include "StudioFixture.h"
#include "ValueSlider.h"

#include <QPushButton>
#include <QSpinBox>

#include <cmath>

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
  auto* percent = find<QSpinBox>("expressionPercent");
  percent->selectAll();
  QTest::keyClicks(percent, "50");
  const double half = largestDisplacement();
  EXPECT_EQ(window->model().state().expressions.at("joy"), 0.5);
  EXPECT_GT(half, 0.2 * full);
  EXPECT_LT(half, 0.8 * full);
  EXPECT_EQ(find<mien::ValueSlider>("expressionIntensity")->value(), 50);
}

TEST_F(ExpressionPanel, TheFAPSlidersShowWhereAnExpressionTakesTheFace) {
  find<QPushButton>("expression_surprise")->click();
  settle();
  auto* slider = find<mien::ValueSlider>("fapSlider33");
  EXPECT_EQ(slider->value(), 0);
  EXPECT_GT(std::abs(slider->shownValue()), 10.0);
}

}  // namespace
