#include "FAPTable.h"
#include "FaceModel.h"
#include "StudioFixture.h"
#include "ValueSlider.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QToolButton>

namespace {

using FAPPanel = StudioFixture;
using mien::ValueSlider;

TEST_F(FAPPanel, HasASliderForEachOfThe22) {
  const std::vector<int> faps = mien::paperSubset();
  ASSERT_EQ(faps.size(), 22u);
  for (int fap : faps) {
    EXPECT_FALSE(find<ValueSlider>(QString("fapSlider%1").arg(fap))->toolTip().isEmpty());
    EXPECT_TRUE(find<QDoubleSpinBox>(QString("fapValue%1").arg(fap))->suffix().size() > 1);
  }
  EXPECT_EQ(find<QTabWidget>("fapTabs")->count(), 5);
}

TEST_F(FAPPanel, DraggingASliderWithTheMouseMovesTheCurves) {
  auto* slider = find<ValueSlider>("fapSlider31");
  ASSERT_TRUE(slider->isVisible());
  const QPoint middle = slider->rect().center();
  ASSERT_EQ(largestDisplacement(), 0.0);
  QTest::mousePress(slider, Qt::LeftButton, Qt::NoModifier, middle);
  dragTo(slider, middle + QPoint(30, 0));
  const double near = largestDisplacement();
  dragTo(slider, middle + QPoint(60, 0));
  QTest::mouseRelease(slider, Qt::LeftButton, Qt::NoModifier, middle + QPoint(60, 0));
  EXPECT_GT(near, 1.0);
  EXPECT_GT(largestDisplacement(), 1.5 * near);
  EXPECT_EQ(window->model().state().fapValues.at(31), slider->value());
}

TEST_F(FAPPanel, KeysMoveASliderAndTheCurves) {
  auto* slider = find<ValueSlider>("fapSlider33");
  slider->setFocus();
  QTest::keyClick(slider, Qt::Key_PageUp);
  QTest::keyClick(slider, Qt::Key_Right);
  EXPECT_EQ(slider->value(), 68);
  EXPECT_GT(largestDisplacement(), 0.5);
}

TEST_F(FAPPanel, NumbersCanBeTypedBeyondTheSlider) {
  auto* number = find<QDoubleSpinBox>("fapValue31");
  number->selectAll();
  QTest::keyClicks(number, "600");
  QTest::keyClick(number, Qt::Key_Return);
  EXPECT_EQ(window->model().state().fapValues.at(31), 600.0);
  EXPECT_EQ(find<ValueSlider>("fapSlider31")->value(), find<ValueSlider>("fapSlider31")->maximum());
  EXPECT_EQ(number->value(), 600.0);
}

TEST_F(FAPPanel, ALengthIsShownInMillimetresOfThisFace) {
  find<QDoubleSpinBox>("fapValue31")->setValue(100.0);
  settle();
  const double expected = 100.0 * window->model().millimetresPerUnit(31);
  EXPECT_GT(expected, 1.0);
  EXPECT_EQ(find<QLabel>("fapLength31")->text(), QString("%1 mm").arg(expected, 0, 'f', 1));
}

TEST_F(FAPPanel, MirrorMovesBothSidesAndNoneWithoutIt) {
  auto* left = find<QDoubleSpinBox>("fapValue31");
  auto* right = find<QDoubleSpinBox>("fapValue32");
  left->setValue(80.0);
  EXPECT_EQ(right->value(), 80.0);
  find<QCheckBox>("fapMirror")->setChecked(false);
  right->setValue(-40.0);
  EXPECT_EQ(left->value(), 80.0);
  EXPECT_EQ(window->model().state().fapValues.at(32), -40.0);
}

TEST_F(FAPPanel, ResetsOneOrAll) {
  find<QDoubleSpinBox>("fapValue31")->setValue(80.0);
  find<QDoubleSpinBox>("fapValue33")->setValue(50.0);
  QTest::mouseClick(find<QToolButton>("fapReset31"), Qt::LeftButton);
  EXPECT_EQ(window->model().state().fapValues.count(31), 0u);
  EXPECT_EQ(window->model().state().fapValues.count(33), 1u);
  EXPECT_GT(largestDisplacement(), 0.5);
  QTest::mouseClick(find<QPushButton>("fapResetAll"), Qt::LeftButton);
  EXPECT_TRUE(window->model().state().fapValues.empty());
  EXPECT_EQ(find<QDoubleSpinBox>("fapValue33")->value(), 0.0);
  EXPECT_EQ(largestDisplacement(), 0.0);
}

TEST_F(FAPPanel, ADoubleClickSetsASliderToZero) {
  find<QDoubleSpinBox>("fapValue31")->setValue(80.0);
  auto* slider = find<ValueSlider>("fapSlider31");
  QTest::mouseDClick(slider, Qt::LeftButton, Qt::NoModifier, QPoint(20, slider->height() / 2));
  EXPECT_EQ(slider->value(), 0);
}

TEST_F(FAPPanel, ThePipelineKeepsUpWithADraggedSlider) {
  auto* slider = find<ValueSlider>("fapSlider33");
  int updates = 0;
  QObject::connect(&window->model(), &mien::FaceModel::updated, [&updates] { ++updates; });
  for (int value = 1; value <= 50; ++value) slider->setValue(4 * value);
  settle();
  EXPECT_EQ(updates, 1) << "changes that come together are shown once";
  EXPECT_EQ(window->model().state().fapValues.at(33), 200.0);
}

}  // namespace
