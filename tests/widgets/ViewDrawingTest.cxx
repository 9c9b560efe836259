#include <vtkAlgorithm.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QToolButton>
#include <algorithm>
#include <array>
#include <cmath>

#include "AnimationPlayer.h"
#include "CurveView.h"
#include "DifferenceArrows.h"
#include "FaceModel.h"
#include "FaceView.h"
#include "StudioFixture.h"
#include "Theme.h"
#include "ViewArea.h"

namespace {

using mien::Theme;

/// What lines, points and arrows look like where pixels decide.
class ViewDrawing : public StudioFixture {
 protected:
  void TearDown() override {
    Theme::apply(Theme::Kind::Light, *qApp);
    StudioFixture::TearDown();
  }
  QImage picture(const char* view) {
    settle();
    return find<QWidget>(view)->grab().toImage();
  }
  void use(Theme::Kind kind) {
    if (Theme::current().kind != kind) find<QAction>("actionDark")->trigger();
    settle();
  }
  static double luminance(const QColor& color) {
    const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
  }
  static double contrast(const QColor& one, const QColor& other) {
    const double a = luminance(one) + 0.05, b = luminance(other) + 0.05;
    return std::max(a, b) / std::min(a, b);
  }
  static int apart(const QColor& one, const QColor& other) {
    return std::abs(one.red() - other.red()) + std::abs(one.green() - other.green()) +
           std::abs(one.blue() - other.blue());
  }
  /// How many pixels of two pictures are clearly not the same.
  static int differing(const QImage& one, const QImage& other, int clearly = 60) {
    int count = 0;
    for (int y = 0; y < one.height(); ++y)
      for (int x = 0; x < one.width(); ++x) count += apart(one.pixelColor(x, y), other.pixelColor(x, y)) > clearly;
    return count;
  }
};

const QSize usualSizes[] = {{1000, 700}, {1280, 800}, {2560, 1440}};

/// Both lie at one place, and would fight for each pixel.
TEST_F(ViewDrawing, WhatHasNotMovedHidesTheNeutralCurves) {
  for (const QSize& size : usualSizes) {
    window->resize(size);
    const QImage both = picture("curveView");
    find<QToolButton>("curveNeutral")->click();
    const int differ = differing(both, picture("curveView"));
    find<QToolButton>("curveNeutral")->click();
    RecordProperty("differing" + std::to_string(size.width()), differ);
    EXPECT_LT(differ, 20) << size.width();
  }
}

/// How much ink a curve has at each of many places along it, from the face's front to its sides: the darkest pixel
/// beside each place, of the colour of the line.
class InkOfCurves {
 public:
  InkOfCurves(mien::CurveView* view, vtkPolyData* curves, const QImage& image)
      : view_(view), image_(image), perCurve_(curves->GetNumberOfPoints() / 29) {
    for (int curve = 2; curve < 20; ++curve)
      for (vtkIdType i = perCurve_ / 4 + 2; i < 3 * perCurve_ / 4 - 2; ++i)
        addSegment(curves->GetPoint(curve * perCurve_ + i), curves->GetPoint(curve * perCurve_ + i + 1));
  }
  double shareBelow(double least) const {
    return static_cast<double>(std::count_if(ink_.begin(), ink_.end(), [&](double ink) { return ink < least; })) /
           ink_.size();
  }
  size_t count() const { return ink_.size(); }

 private:
  void addSegment(const double* from, const double* to) {
    const std::array<double, 3> a = {from[0], from[1], from[2]}, b = {to[0], to[1], to[2]};
    for (double share : {0.125, 0.375, 0.625, 0.875}) {
      double x = a[0] + share * (b[0] - a[0]), y = a[1] + share * (b[1] - a[1]), z = a[2] + share * (b[2] - a[2]);
      view_->renderer()->WorldToView(x, y, z);
      ink_.push_back(inkAt(0.5 * (x + 1.0) * image_.width(), 0.5 * (1.0 - y) * image_.height()));
    }
  }
  double inkAt(double x, double y) const {
    const QColor line = Theme::current().curve, ground = Theme::current().viewBottom;
    double most = 0.0;
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy) {
        const QPoint at(static_cast<int>(x) + dx, static_cast<int>(y) + dy);
        if (!image_.rect().contains(at)) continue;
        const double lightness = image_.pixelColor(at).lightnessF();
        most = std::max(most, (lightness - ground.lightnessF()) / (line.lightnessF() - ground.lightnessF()));
      }
    return most;
  }

  mien::CurveView* view_;
  QImage image_;
  vtkIdType perCurve_;
  std::vector<double> ink_;
};

TEST_F(ViewDrawing, CurvesHaveNoGaps) {
  find<QToolButton>("curvePoints")->click();
  auto* view = find<mien::CurveView>("curveView");
  for (Theme::Kind kind : {Theme::Kind::Light, Theme::Kind::Dark}) {
    use(kind);
    for (const QSize& size : usualSizes) {
      window->resize(size);
      const QImage shown = picture("curveView");
      auto* curves = vtkPolyData::SafeDownCast(window->model().pipeline().curves()->GetOutputDataObject(0));
      const InkOfCurves ink(view, curves, shown);
      ASSERT_GT(ink.count(), 500u);
      RecordProperty("gaps" + std::to_string(size.width()), std::to_string(ink.shareBelow(0.5)));
      EXPECT_LT(ink.shareBelow(0.5), 0.01) << size.width() << " " << int(kind);
    }
  }
}

/// A button that is pressed says so: in small views they are small.
TEST_F(ViewDrawing, PointsOfCurvesAreSeenInViewsOfAnySize) {
  for (const QSize& size : usualSizes)
    for (const char* dock : {"", "plotDock"}) {
      if (*dock) find<QDockWidget>(dock)->show();
      window->resize(size);
      const QImage with = picture("curveView");
      find<QToolButton>("curvePoints")->click();
      EXPECT_GT(differing(with, picture("curveView")), 300) << size.width() << " " << dock;
      find<QToolButton>("curvePoints")->click();
      if (*dock) find<QDockWidget>(dock)->hide();
    }
}

/// Lines and points alone, and curves over them, are told from the background by day and by night.
TEST_F(ViewDrawing, LinesOfAMeshAloneStandOut) {
  auto* mesh = find<QComboBox>("faceMesh");
  for (Theme::Kind kind : {Theme::Kind::Light, Theme::Kind::Dark}) {
    const Theme& theme = Theme::of(kind);
    for (const QColor& ground : {theme.viewTop, theme.viewBottom}) EXPECT_GE(contrast(theme.meshAlone, ground), 4.0);
    use(kind);
    for (const char* style : {"Wireframe", "Points"}) {
      mesh->setCurrentText(style);
      const QImage shown = picture("faceView");
      int clear = 0;
      for (int y = 0; y < shown.height(); ++y) {
        const QColor ground = shown.pixelColor(1, y);
        for (int x = shown.width() / 4; x < 3 * shown.width() / 4; ++x)
          clear += contrast(shown.pixelColor(x, y), ground) >= 3.0;
      }
      RecordProperty(std::string(style) + (kind == Theme::Kind::Dark ? "Dark" : "Light"), clear);
      EXPECT_GT(clear, 500) << style << " " << int(kind);
    }
  }
}

TEST_F(ViewDrawing, CurvesOverAMeshAloneStandOut) {
  for (Theme::Kind kind : {Theme::Kind::Light, Theme::Kind::Dark}) {
    use(kind);
    find<QComboBox>("faceMesh")->setCurrentText("Points");
    const QImage without = picture("faceView");
    find<QToolButton>("faceCurves")->click();
    const QImage with = picture("faceView");
    int clear = 0;
    for (int y = 0; y < with.height(); ++y)
      for (int x = 0; x < with.width(); ++x)
        clear +=
            with.pixel(x, y) != without.pixel(x, y) && contrast(with.pixelColor(x, y), with.pixelColor(1, y)) >= 4.0;
    find<QToolButton>("faceCurves")->click();
    EXPECT_GT(clear, 2000) << int(kind);
  }
}

/// Lips that just part are less than a pixel apart: of a dark mouth behind them there would be dashes for a frame.
TEST_F(ViewDrawing, LipsThatMeetShowNoDashes) {
  window->resize(1280, 800);
  find<QDockWidget>("plotDock")->show();
  window->playDemonstration();
  window->player().pause();
  const auto lips = [&](int frame) {  // without the chin, whose outline moves
    window->model().showFrame(frame);
    const QImage shown = picture("faceView");
    return shown.copy(2 * shown.width() / 5, shown.height() / 2, shown.width() / 5, shown.height() / 5);
  };
  const QImage closed = lips(128);
  EXPECT_GT(differing(closed, lips(127), 15), 0) << "they are a little apart";
  EXPECT_EQ(differing(closed, lips(127), 120), 0);
  EXPECT_GT(differing(closed, lips(126), 120), 50) << "an open mouth is dark";
}

/// White with a dark rim, on both faces alike: those that lead into a face are not cut off by it.
TEST_F(ViewDrawing, ArrowsOfAComparisonStandOutOnBothFaces) {
  auto* choice = find<QComboBox>("compareWith");
  emit choice->activated(choice->findText("Keep this state"));
  window->model().change([](mien::FaceState& state) { state.expressions = {{"joy", 1.0}}; });
  settle();
  for (Theme::Kind kind : {Theme::Kind::Light, Theme::Kind::Dark}) {
    use(kind);
    std::array<int, 2> white{};
    for (int index : {0, 2}) {
      find<QComboBox>("compareArrows")->setCurrentIndex(index);
      for (int side : {0, 1}) {
        const QImage shown = picture(side == 0 ? "faceView" : "otherFaceView");
        int count = 0;
        for (int y = 0; y < shown.height(); ++y)
          for (int x = 0; x < shown.width(); ++x) count += apart(shown.pixelColor(x, y), Qt::white) < 30;
        white[side] = index == 0 ? -count : white[side] + count;
      }
    }
    for (int side : {0, 1}) RecordProperty("white" + std::to_string(side), white[side]);
    EXPECT_GT(std::min(white[0], white[1]), 600) << int(kind);
    EXPECT_GT(std::min(white[0], white[1]), std::max(white[0], white[1]) / 2) << int(kind);
    find<QComboBox>("compareArrows")->setCurrentIndex(0);
  }
}

TEST_F(ViewDrawing, ArrowsOfAComparisonKeepApart) {
  auto* choice = find<QComboBox>("compareWith");
  emit choice->activated(choice->findText("Keep this state"));
  window->model().change([](mien::FaceState& state) { state.expressions = {{"joy", 1.0}}; });
  find<QComboBox>("compareArrows")->setCurrentIndex(2);
  settle();
  for (const auto* one : find<mien::ViewArea>("viewArea")->findChildren<mien::DifferenceArrows*>()) {
    const auto& arrows = one->arrows();
    ASSERT_GT(arrows.size(), 50u);
    for (size_t i = 0; i < arrows.size(); ++i)
      for (size_t k = 0; k < i; ++k) ASSERT_GE((arrows[i].tail - arrows[k].tail).norm(), 6.0);
  }
}

}  // namespace
