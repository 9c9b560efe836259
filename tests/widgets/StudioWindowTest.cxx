#include <vtkCamera.h>
#include <vtkMath.h>

#include <QAction>
#include <QApplication>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QToolButton>
#include <array>
#include <cmath>

#include "CurveView.h"
#include "FaceModel.h"
#include "StudioFixture.h"
#include "Theme.h"

namespace {

using StudioWindow = StudioFixture;
using mien::CurveView;
using mien::FaceView;

std::array<double, 3> direction(mien::RenderView* view) {
  std::array<double, 3> out;
  view->camera()->GetDirectionOfProjection(out.data());
  return out;
}

void drag(QWidget* widget, QPoint by) {
  const QPoint middle = widget->rect().center();
  QTest::mousePress(widget, Qt::LeftButton, Qt::NoModifier, middle);
  for (int i = 1; i <= 4; ++i) QTest::mouseMove(widget, middle + by * i / 4);
  QTest::mouseRelease(widget, Qt::LeftButton, Qt::NoModifier, middle + by);
}

TEST_F(StudioWindow, StartsWithTheNeutralFaceInBothViews) {
  EXPECT_EQ(window->model().state(), mien::FaceState());
  EXPECT_EQ(largestDisplacement(), 0.0);
  EXPECT_GT(colorsIn("faceView"), 200);
  EXPECT_GT(colorsIn("curveView"), 50);
  EXPECT_EQ(message(), "");
}

TEST_F(StudioWindow, FitsIntoASmallScreen) {
  EXPECT_LE(window->minimumSizeHint().width(), 1280);
  EXPECT_LE(window->minimumSizeHint().height(), 800);
  EXPECT_EQ(window->size(), QSize(1280, 800));
}

TEST_F(StudioWindow, ShadedWireframeAndBothLookDifferent) {
  auto* view = find<FaceView>("faceView");
  const QImage shaded = view->grab().toImage();
  find<QToolButton>("meshWireframe")->click();
  settle();
  const QImage wireframe = view->grab().toImage();
  find<QToolButton>("meshBoth")->click();
  settle();
  const QImage both = view->grab().toImage();
  EXPECT_NE(shaded, wireframe);
  EXPECT_NE(wireframe, both);
  EXPECT_NE(shaded, both);
  EXPECT_FALSE(find<QToolButton>("meshShaded")->isChecked());
}

TEST_F(StudioWindow, SidesAreLookedAtFromTheRightDirection) {
  auto* face = find<FaceView>("faceView");
  const double root = std::sqrt(0.5);
  const std::pair<const char*, std::array<double, 3>> sides[] = {
      {"lookSide", {-1, 0, 0}}, {"lookFortyFive", {-root, 0, -root}}, {"lookFront", {0, 0, -1}}};
  for (const auto& [button, expected] : sides) {
    QTest::mouseClick(find<QToolButton>(button), Qt::LeftButton);
    settle();
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(direction(face)[i], expected[i], 1e-12) << button;
    EXPECT_GT(colorsIn("faceView"), 200) << button;
  }
}

TEST_F(StudioWindow, DraggingTurnsTheFaceAndTheLinkedCurves) {
  auto* face = find<FaceView>("faceView");
  auto* curves = find<CurveView>("curveView");
  const auto before = direction(face);
  drag(face, {80, 30});
  EXPECT_LT(vtkMath::Dot(before.data(), direction(face).data()), 0.99);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(direction(curves)[i], direction(face)[i], 1e-12);
  drag(curves, {-60, 10});
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(direction(curves)[i], direction(face)[i], 1e-12);
  QTest::mouseClick(find<QToolButton>("lookReset"), Qt::LeftButton);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(direction(face)[i], before[i], 1e-12);
}

TEST_F(StudioWindow, AnUnlinkedViewKeepsItsOwnCamera) {
  auto* face = find<FaceView>("faceView");
  auto* curves = find<CurveView>("curveView");
  QTest::mouseClick(find<QToolButton>("curveLink"), Qt::LeftButton);
  const auto before = direction(curves);
  drag(face, {80, 30});
  EXPECT_EQ(direction(curves), before);
  EXPECT_NE(direction(face), before);
  QTest::mouseClick(find<QToolButton>("curveLink"), Qt::LeftButton);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(direction(curves)[i], direction(face)[i], 1e-12);
}

TEST_F(StudioWindow, MovedCurvesAreSeen) {
  auto* curves = find<CurveView>("curveView");
  const QImage neutral = curves->grab().toImage();
  find<QDoubleSpinBox>("fapValue33")->setValue(200.0);
  settle();
  EXPECT_NE(curves->grab().toImage(), neutral);
}

TEST_F(StudioWindow, CurvePartsCanBeHidden) {
  auto* curves = find<CurveView>("curveView");
  find<QDoubleSpinBox>("fapValue33")->setValue(200.0);
  settle();
  QImage last = curves->grab().toImage();
  for (const char* part : {"curvePoints", "curveNeutral", "curveFrontOnly"}) {
    find<QToolButton>(part)->click();
    settle();
    const QImage now = curves->grab().toImage();
    EXPECT_NE(now, last) << part;
    last = now;
  }
}

TEST_F(StudioWindow, TheNeutralFaceIsOneCommandAway) {
  find<QDoubleSpinBox>("fapValue33")->setValue(200.0);
  find<QPushButton>("expression_joy")->click();
  ASSERT_TRUE(window->openAnimation(writeLids(11, 5)));
  window->model().showFrame(8);
  find<QAction>("actionNeutral")->trigger();
  EXPECT_EQ(largestDisplacement(), 0.0);
  EXPECT_EQ(window->model().frameCount(), 0);
  EXPECT_FALSE(find<QPushButton>("expression_joy")->isChecked());
}

TEST_F(StudioWindow, DarkColoursReachTheViews) {
  const QRgb light = find<FaceView>("faceView")->grab().toImage().pixel(3, 3);
  find<QAction>("actionDark")->trigger();
  settle();
  const QRgb dark = find<FaceView>("faceView")->grab().toImage().pixel(3, 3);
  EXPECT_GT(qGray(light), 180);
  EXPECT_LT(qGray(dark), 90);
  mien::Theme::apply(mien::Theme::Kind::Light, *qApp);
}

}  // namespace
