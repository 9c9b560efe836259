#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QTemporaryDir>
#include <QToolButton>

#include "AnimationPlayer.h"
#include "ExportButton.h"
#include "FAPSequence.h"
#include "FAPWriter.h"
#include "FaceModel.h"
#include "LiveMotion.h"
#include "MotionField.h"
#include "MotionVectorFigure.h"
#include "RecentMotion.h"
#include "StudioFixture.h"
#include "VectorControls.h"
#include "VectorPanel.h"
#include "VectorView.h"

namespace {

constexpr int patience = 30000;  // ms, of a loaded machine

class VectorPanel : public StudioFixture {
 protected:
  VectorPanel() {
    find<QAction>("vectorsDockAction")->trigger();
    view = find<mien::VectorView>("vectorFigure");
    EXPECT_TRUE(waitUntil([this] { return view->figure() != nullptr; }, patience));
    QObject::connect(&motion(), &mien::LiveMotion::finished, [this] { ++drawn; });
  }

  const mien::LiveMotion& motion() { return find<mien::VectorPanel>("vectorPanel")->motion(); }
  const mien::MotionRequest& shown() { return motion().result().request; }
  double largest() { return motion().result().field->magnitudes().maxCoeff(); }
  const mien::VectorPicture& picture() { return view->figure()->panels().front().picture(); }

  /// Waits until what is drawn has this property.
  bool comes(const std::function<bool()>& property) { return waitUntil(property, patience); }

  void setFAP(int fap, double value) {
    window->model().change([&](mien::FaceState& state) { state.fapValues[fap] = value; });
  }

  mien::VectorView* view;
  int drawn = 0;
};

TEST_F(VectorPanel, AutomaticChoicesShowWhatIsInEffect) {
  setFAP(3, 500.0);
  ASSERT_TRUE(comes([this] { return !picture().arrows.empty(); }));
  settle();
  const mien::MotionVectorFigure& figure = *view->figure();
  const auto shown = [this](const char* name) { return find<QDoubleSpinBox>(name)->value(); };
  EXPECT_NEAR(shown("vectorsScaleValue"), figure.scale(), 0.005);
  EXPECT_NEAR(shown("vectorsRangeValue"), figure.rangeEnd(), 0.005);
  ASSERT_EQ(figure.sampling().kind, mien::VectorSampling::Kind::Even);
  EXPECT_NEAR(shown("vectorsSpacing"), figure.sampling().spacing, 0.05);
  for (const char* name : {"vectorsScaleValue", "vectorsRangeValue", "vectorsSpacing"})
    EXPECT_FALSE(find<QDoubleSpinBox>(name)->isEnabled()) << name;
}

TEST_F(VectorPanel, TheNeutralFaceHasNoArrows) {
  EXPECT_TRUE(picture().arrows.empty());
  EXPECT_TRUE(find<QLabel>("vectorsNumbers")->text().startsWith("max 0.00, mean 0.00 mm; 0 of "))
      << find<QLabel>("vectorsNumbers")->text().toStdString();
}

TEST_F(VectorPanel, FollowsTheFaceWhileASliderMoves) {
  setFAP(33, 200.0);
  EXPECT_TRUE(comes([this] { return shown().moved.fapValues.count(33) && !picture().arrows.empty(); }));
  const double first = largest();
  EXPECT_NEAR(first, 200.0 * window->model().millimetresPerUnit(33), 0.2 * first)
      << "as far as the feature point, nearly";
  setFAP(33, 400.0);
  EXPECT_TRUE(comes([&] { return largest() > 1.5 * first; }));
}

TEST_F(VectorPanel, FollowsAPlayingAnimation) {
  ASSERT_TRUE(window->openAnimation(writeLids(500, 25)));
  window->player().play();
  EXPECT_TRUE(comes([this] { return drawn > 3 && shown().moved.frame > 3.0 && !picture().arrows.empty(); }));
  window->player().pause();
}

/// A nod that grows, and a turn at the end that is much stronger.
QString writeNods(const QTemporaryDir& folder) {
  mien::FAPSequence sequence;
  for (int i = 0; i < 30; ++i) {
    mien::FAPFrame frame;
    frame.number = i;
    frame.setValue(48, 400.0 * i);
    if (i == 29) frame.setValue(49, 60000.0);
    sequence.frames.push_back(frame);
  }
  std::string text;
  EXPECT_EQ(mien::writeFAP(sequence, text), "");
  QFile file(folder.filePath("nods.fap"));
  EXPECT_TRUE(file.open(QIODevice::WriteOnly) && file.write(text.data(), text.size()) > 0);
  return file.fileName();
}

TEST_F(VectorPanel, ScaleAndRangeOfAFileAreThoseOfItsStrongestFrameAllTheTime) {
  const QTemporaryDir folder;
  ASSERT_TRUE(window->openAnimation(writeNods(folder)));
  const auto showFrame = [this](double frame) {
    window->model().showFrame(frame);
    return comes([&] { return shown().moved.frame == frame && !shown().moved.fapFile.empty(); });
  };
  ASSERT_TRUE(showFrame(1.0));
  const double scale = view->figure()->scale(), end = view->figure()->rangeEnd();
  EXPECT_GT(end, 20.0 * largest()) << "which moves hardly yet";
  for (const double frame : {5.0, 15.0, 28.0, 29.0, 2.0}) {
    ASSERT_TRUE(showFrame(frame)) << frame;
    EXPECT_EQ(view->figure()->scale(), scale) << frame;
    EXPECT_EQ(view->figure()->rangeEnd(), end) << frame;
    if (frame == 29.0) {
      EXPECT_GE(end, picture().largest());
      EXPECT_LT(end, 1.6 * picture().largest());
    }
  }
  window->model().closeAnimation();
  setFAP(33, 60.0);
  ASSERT_TRUE(comes([this] { return shown().moved.fapFile.empty() && shown().moved.fapValues.count(33) > 0; }));
  EXPECT_LT(view->figure()->scale(), 0.5 * scale);
  EXPECT_LT(view->figure()->rangeEnd(), 0.5 * end);
}

TEST_F(VectorPanel, DrawsNothingWhileHidden) {
  EXPECT_TRUE(comes([this] { return !motion().result().request.moved.fapValues.count(33); }));
  find<QDockWidget>("vectorsDock")->hide();
  settle();
  QTest::qWait(300);
  drawn = 0;
  for (int i = 1; i <= 10; ++i) {
    setFAP(33, 20.0 * i);
    QTest::qWait(60);
  }
  EXPECT_EQ(drawn, 0);
  find<QDockWidget>("vectorsDock")->show();
  EXPECT_TRUE(comes([this] { return shown().moved.fapValues.count(33) && shown().moved.fapValues.at(33) == 200.0; }));
}

TEST_F(VectorPanel, APinnedStateIsWhereTheVectorsStart) {
  setFAP(33, 200.0);
  settle();
  find<QToolButton>("vectorsPin")->click();
  EXPECT_TRUE(comes([this] { return shown().origin.fapValues.count(33) > 0; }));
  EXPECT_LT(largest(), 1e-9) << "the state pinned, from itself";
  setFAP(33, 300.0);
  EXPECT_TRUE(comes([this] { return shown().moved.fapValues.at(33) == 300.0; }));
  EXPECT_NEAR(largest(), 100.0 * window->model().millimetresPerUnit(33), 1.5);
  window->model().change([](mien::FaceState& state) { state.fapValues.clear(); });
  find<QToolButton>("vectorsPin")->click();
  auto* against = find<QComboBox>("vectorsAgainst");
  ASSERT_EQ(against->count(), 4) << "both pins are kept";
  against->setCurrentIndex(2);
  EXPECT_TRUE(comes([this] { return shown().origin.fapValues.count(33) > 0 && shown().moved.fapValues.empty(); }));
  EXPECT_NEAR(largest(), 200.0 * window->model().millimetresPerUnit(33), 3.0);
  find<QToolButton>("vectorsUnpin")->click();
  EXPECT_EQ(against->count(), 3);
}

TEST_F(VectorPanel, ADraggedRectangleIsTheRegion) {
  setFAP(51, -200.0);
  setFAP(33, 200.0);
  EXPECT_TRUE(comes([this] { return shown().moved.fapValues.count(33) > 0; }));
  const size_t all = motion().result().chosen.size();
  const Eigen::AlignedBox2d frame = picture().frame;
  const Eigen::Vector2d middle = frame.center();
  const QPoint from = view->pixelOf({frame.min().x(), frame.max().y()}).toPoint(),
               to = view->pixelOf({frame.max().x(), middle.y()}).toPoint();
  QTest::mousePress(view, Qt::LeftButton, Qt::NoModifier, from);
  dragTo(view, to);
  QTest::mouseRelease(view, Qt::LeftButton, Qt::NoModifier, to);
  EXPECT_TRUE(comes([this] { return shown().options.picture.region.rectangle.has_value(); }));
  const Eigen::AlignedBox2d region = *shown().options.picture.region.rectangle;
  const double pixel = frame.sizes().x() / std::abs(to.x() - from.x());  // mm
  EXPECT_NEAR(region.min().y(), middle.y(), 2.0 * pixel);
  EXPECT_NEAR(region.max().x(), frame.max().x(), 2.0 * pixel);
  EXPECT_LT(motion().result().chosen.size(), 0.8 * all);
  for (const mien::PictureArrow& arrow : picture().arrows) EXPECT_TRUE(region.contains(arrow.tail));
  QTest::mouseDClick(view, Qt::LeftButton);
  EXPECT_TRUE(comes([this] { return shown().options.picture.region.isWhole(); }));
}

TEST_F(VectorPanel, ScaleAndRangeStayWhileTheMotionShrinksAndFitChoosesThemAnew) {
  setFAP(33, 400.0);
  EXPECT_TRUE(comes([this] { return !picture().arrows.empty(); }));
  const double scale = view->figure()->scale(), end = view->figure()->rangeEnd();
  setFAP(33, 60.0);
  EXPECT_TRUE(comes([this] { return shown().moved.fapValues.at(33) == 60.0; }));
  EXPECT_EQ(view->figure()->scale(), scale);
  EXPECT_EQ(view->figure()->rangeEnd(), end);
  find<QToolButton>("vectorsFit")->click();
  EXPECT_TRUE(comes([&] { return view->figure()->scale() < scale; }));
  EXPECT_LT(view->figure()->rangeEnd(), end);
}

TEST_F(VectorPanel, ScaleAndRangeFollowAMotionThatStaysSmaller) {
  setFAP(33, 400.0);
  EXPECT_TRUE(comes([this] { return !picture().arrows.empty(); }));
  const double scale = view->figure()->scale(), end = view->figure()->rangeEnd();
  double value = 60.0;
  EXPECT_TRUE(comes([&] {
    setFAP(33, value = value < 60.5 ? 61.0 : 60.0);
    return view->figure()->scale() < 0.5 * scale && view->figure()->rangeEnd() < 0.5 * end;
  }));
}

TEST(RecentMotion, TellsTheMostOfTheLastTwoSecondsAndNothingBefore) {
  mien::RecentMotion recent;
  const mien::RecentMotion::Time start{};
  const auto at = [&](int i) { return start + std::chrono::milliseconds(100 * i); };
  EXPECT_FALSE(recent.add(at(0), {30.0, 40.0}));
  for (int i = 1; i < 20; ++i) EXPECT_FALSE(recent.add(at(i), {1.0 + 0.1 * i, 5.0})) << i;
  const auto most = recent.add(at(20), {1.0, 5.0});
  ASSERT_TRUE(most);
  EXPECT_DOUBLE_EQ(most->drawn, 2.9) << "the long one is two seconds old";
  EXPECT_DOUBLE_EQ(most->colored, 5.0);
  recent.clear();
  for (int i = 0; i < 5; ++i) EXPECT_FALSE(recent.add(at(100 * i), {1.0, 1.0})) << "ten pictures at least";
}

TEST_F(VectorPanel, RectanglesTakeEachOthersPlaceInTheList) {
  auto* regions = find<QComboBox>("vectorsRegion");
  auto* controls = find<mien::VectorControls>("vectorControls");
  const int before = regions->count();
  for (int i = 0; i < 5; ++i) controls->setRegion({Eigen::Vector2d(-10.0 - i, -20.0), Eigen::Vector2d(10.0, 20.0)});
  EXPECT_EQ(regions->count(), before + 1);
  EXPECT_EQ(controls->region(), "-14.0,-20.0,10.0,20.0");
  EXPECT_TRUE(comes([this] {
    const auto& rectangle = shown().options.picture.region.rectangle;
    return rectangle && rectangle->min().x() == -14.0;
  }));
}

TEST_F(VectorPanel, ControlsReachTheFigure) {
  setFAP(33, 300.0);
  EXPECT_TRUE(comes([this] { return !picture().arrows.empty(); }));
  EXPECT_EQ(shown().options.picture.sampling.kind, mien::VectorSampling::Kind::Automatic);
  find<QComboBox>("vectorsSampling")->setCurrentIndex(1);
  EXPECT_TRUE(comes([this] { return shown().options.picture.sampling.kind == mien::VectorSampling::Kind::Even; }));
  const size_t even = motion().result().chosen.size();
  auto* spacing = find<QDoubleSpinBox>("vectorsSpacing");  // begins with what was automatic
  spacing->setValue(2.0 * spacing->value());
  EXPECT_TRUE(comes([&] { return motion().result().chosen.size() < 0.5 * even; }));
  find<QComboBox>("vectorsScale")->setCurrentIndex(2);
  find<QDoubleSpinBox>("vectorsScaleValue")->setValue(4.0);
  EXPECT_TRUE(comes([&] { return view->figure()->scale() == 4.0; }));
  find<QComboBox>("vectorsRange")->setCurrentIndex(1);
  find<QDoubleSpinBox>("vectorsRangeValue")->setValue(33.0);
  EXPECT_TRUE(comes([&] { return view->figure()->rangeEnd() == 33.0; }));
  find<QComboBox>("vectorsColorMap")->setCurrentText("magma");
  EXPECT_TRUE(comes([&] { return shown().options.colorMap == "magma"; }));
  find<QComboBox>("vectorsView")->setCurrentIndex(2);
  EXPECT_TRUE(comes([&] { return shown().options.picture.plane.out.x() == 1.0; }));
  find<QComboBox>("vectorsRegion")->setCurrentText("Brows");
  EXPECT_TRUE(comes([&] { return shown().options.picture.region.box.has_value(); }));
}

TEST_F(VectorPanel, TheHeadsRotationCanBeLeftOut) {
  setFAP(49, 20000.0);
  EXPECT_TRUE(comes([this] { return shown().moved.fapValues.count(49) && largest() > 10.0; }));
  find<QCheckBox>("vectorsHead")->click();
  EXPECT_TRUE(comes([this] { return shown().headMotionRemoved; }));
  EXPECT_LT(largest(), 1e-6);
}

TEST_F(VectorPanel, LooksFromWhereTheFaceIsSeen) {
  auto* from = find<QComboBox>("vectorsView");
  from->setCurrentIndex(from->count() - 1);
  find<QToolButton>("lookSide")->click();
  EXPECT_TRUE(comes([&] { return shown().options.picture.plane.out.x() > 0.999; }));
}

TEST_F(VectorPanel, WritesItsFigureAndNumbers) {
  setFAP(33, 200.0);
  EXPECT_TRUE(comes([this] { return !picture().arrows.empty(); }));
  QTemporaryDir folder;
  auto* button = find<mien::ExportButton>("vectorsExport");
  for (const char* name : {"v.svg", "v.pdf", "v.png"}) {
    EXPECT_TRUE(button->write(folder.filePath(name))) << name;
    EXPECT_GT(QFile(folder.filePath(name)).size(), 5000) << name;
  }
  EXPECT_TRUE(button->write(folder.filePath("v.csv")));
  QFile csv(folder.filePath("v.csv"));
  ASSERT_TRUE(csv.open(QIODevice::ReadOnly));
  const QList<QByteArray> lines = csv.readAll().trimmed().split('\n');
  EXPECT_EQ(lines[0], "u,v,x,y,z,dx,dy,dz,magnitude_mm");
  ASSERT_EQ(lines.size(), static_cast<int>(motion().result().chosen.size()) + 1);
  const QList<QByteArray> row = lines[1].split(',');
  ASSERT_EQ(row.size(), 9);
  const double length =
      std::sqrt(std::pow(row[5].toDouble(), 2) + std::pow(row[6].toDouble(), 2) + std::pow(row[7].toDouble(), 2));
  EXPECT_NEAR(length, row[8].toDouble(), 1e-12);
}

TEST_F(VectorPanel, TheWindowMayCloseWhileItMeasures) {
  setFAP(33, 200.0);
  settle();
  QTest::qWait(60);
  window.reset();
}

}  // namespace
