#include <vtkPolyData.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLocale>
#include <QPushButton>
#include <QSpinBox>
#include <cmath>

#include "FaceModel.h"
#include "StudioFixture.h"

namespace {

using SurfacePanel = StudioFixture;

/// Qt drops the sign that its language takes for grouping digits: 2,5 was 25.
TEST_F(SurfacePanel, APointAndACommaAreTheDecimalSign) {
  auto* smoothing = find<QDoubleSpinBox>("surfaceSmoothing");
  for (const QLocale& locale : {QLocale::c(), QLocale(QLocale::German)})
    for (const char* text : {"2,5", "2.5"}) {
      smoothing->setLocale(locale);
      smoothing->setValue(1.0);
      smoothing->setFocus();
      smoothing->selectAll();
      QTest::keyClicks(smoothing, text);
      QTest::keyClick(smoothing, Qt::Key_Return);
      EXPECT_EQ(smoothing->value(), 2.5) << text << " in " << locale.name().toStdString();
    }
}

TEST_F(SurfacePanel, TheMeshHasTheRowsAndColumnsAskedFor) {
  find<QSpinBox>("surfaceRows")->setValue(29);
  find<QSpinBox>("surfaceColumns")->setValue(60);
  EXPECT_EQ(surface()->GetNumberOfPoints(), 29 * 61);
}

TEST_F(SurfacePanel, EverySchemeShapesTheSurfaceItsOwnWay) {
  auto* scheme = find<QComboBox>("surfaceScheme");
  std::set<double> heights;
  ASSERT_GE(scheme->count(), 4);
  for (int i = 0; i < scheme->count(); ++i) {
    scheme->setFocus();
    scheme->setCurrentIndex(i);
    double sum = 0.0;
    for (vtkIdType p = 0; p < surface()->GetNumberOfPoints(); ++p) sum += std::abs(surface()->GetPoint(p)[2]);
    heights.insert(sum);
  }
  EXPECT_EQ(static_cast<int>(heights.size()), scheme->count());
  EXPECT_EQ(message(), "");
}

TEST_F(SurfacePanel, ModesAndSmoothingReachTheState) {
  auto* modes = find<QSpinBox>("surfaceModes");
  EXPECT_EQ(modes->maximum(), 20);
  QTest::keyClick(modes, Qt::Key_Up);
  EXPECT_EQ(window->model().state().surface.modes, 6);
  auto* smoothing = find<QDoubleSpinBox>("surfaceSmoothing");
  smoothing->selectAll();
  QTest::keyClicks(smoothing, "2.5");
  QTest::keyClick(smoothing, Qt::Key_Return);
  for (double a : window->model().state().surface.smoothing) EXPECT_EQ(a, 2.5);
  find<QCheckBox>("surfaceRemainder")->click();
  EXPECT_FALSE(window->model().state().surface.remainder);
}

TEST_F(SurfacePanel, ARefusedSmoothingSaysWhyAndGoesBack) {
  find<QComboBox>("surfaceScheme")->setCurrentText("four-curve");
  settle();
  const vtkIdType points = surface()->GetNumberOfPoints();
  find<QDoubleSpinBox>("surfaceSmoothing")->setValue(300.0);
  settle();
  EXPECT_FALSE(message().isEmpty());
  EXPECT_EQ(find<QDoubleSpinBox>("surfaceSmoothing")->value(), 1.0);
  EXPECT_EQ(find<QComboBox>("surfaceScheme")->currentText(), "four-curve");
  EXPECT_EQ(surface()->GetNumberOfPoints(), points);
  EXPECT_GT(colorsIn("faceView"), 200);
}

TEST_F(SurfacePanel, DefaultsComeBack) {
  find<QSpinBox>("surfaceRows")->setValue(83);
  find<QSpinBox>("surfaceModes")->setValue(2);
  find<QPushButton>("surfaceReset")->click();
  EXPECT_EQ(window->model().state(), mien::FaceState());
  EXPECT_EQ(surface()->GetNumberOfPoints(), 56 * 41);
}

}  // namespace
