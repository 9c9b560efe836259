#include <vtkActor2DCollection.h>
#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QToolButton>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "FaceModel.h"
#include "History.h"
#include "FaceView.h"
#include "PatchColors.h"
#include "StudioFixture.h"

namespace {

using mien::FaceView;

class FaceColoring : public StudioFixture {
 protected:
  QComboBox* choice() { return find<QComboBox>("colorBy"); }
  void choose(const QString& text) {
    ASSERT_GE(choice()->findText(text), 0) << text.toStdString();
    choice()->setCurrentText(text);
    settle();
  }
  double begin() { return find<QDoubleSpinBox>("colorBegin")->value(); }
  double end() { return find<QDoubleSpinBox>("colorEnd")->value(); }
  QImage picture() {
    settle();
    return find<FaceView>("faceView")->grab().toImage();
  }
};

const QString meanCurvature = "Mean curvature H (1/mm)";

TEST_F(FaceColoring, EveryChoiceLooksDifferent) {
  std::vector<QImage> pictures;
  for (const char* name : {"Skin", "Patches", "Mean curvature H (1/mm)", "Normal y", "Texture coordinate x"}) {
    choose(name);
    pictures.push_back(picture());
    for (size_t other = 0; other + 1 < pictures.size(); ++other) EXPECT_NE(pictures.back(), pictures[other]) << name;
  }
  choose("Skin");
  EXPECT_EQ(picture(), pictures.front());
}

/// The hue of a lit colour stays: a patch on the forehead has the hue of its colour and no other.
TEST_F(FaceColoring, PatchesHaveTheirOwnColours) {
  choose("Patches");
  const QImage shown = picture();
  for (int patch = 0; patch < 8; ++patch) {
    const QColor wanted(mien::patchColors[patch]);
    int pixels = 0;
    for (int y = 0; y < shown.height(); y += 2)
      for (int x = shown.width() / 3; x < shown.width(); x += 2) {
        const QColor color = shown.pixelColor(x, y);
        const int apart = std::abs(color.hsvHue() - wanted.hsvHue());
        pixels += std::min(apart, 360 - apart) < 8 && std::abs(color.hsvSaturation() - wanted.hsvSaturation()) < 40;
      }
    EXPECT_GT(pixels, 60) << "P" << patch;
  }
}

TEST_F(FaceColoring, ComputesCurvaturesOnlyWhileTheyAreShown) {
  EXPECT_FALSE(surface()->GetPointData()->HasArray("MeanCurvature"));
  choose(meanCurvature);
  EXPECT_TRUE(surface()->GetPointData()->HasArray("MeanCurvature"));
  choose("Patches");
  EXPECT_FALSE(surface()->GetPointData()->HasArray("MeanCurvature"));
  EXPECT_TRUE(surface()->GetCellData()->HasArray("PatchId"));
}

TEST_F(FaceColoring, OffersEveryArrayOfTheSurface) {
  for (const char* name : {"Normal x", "Normal y", "Normal z", "Texture coordinate x", "Texture coordinate y"})
    EXPECT_GE(choice()->findText(name), 0) << name;
  EXPECT_EQ(choice()->findText("Displacement (mm)"), -1);
  window->model().openDeformationTable("joy");
  settle();
  EXPECT_GE(choice()->findText("Displacement (mm)"), 0);
  choose("Displacement (mm)");
  EXPECT_EQ(begin(), 0.0);
  EXPECT_GE(end(), 0.9 * surface()->GetPointData()->GetArray("Displacement")->GetMaxNorm() / 2.0);
}

TEST_F(FaceColoring, AnArrayThatTheSurfaceLosesGivesWayToTheSkin) {
  choose(meanCurvature);
  window->model().openDeformationTable("joy");
  settle();
  EXPECT_EQ(choice()->currentText(), "Skin");
  EXPECT_TRUE(message().contains("curvature")) << message().toStdString();
}

TEST_F(FaceColoring, AnAutomaticRangeIsSymmetricGrowsAndNeverShrinks) {
  choose(meanCurvature);
  const double first = end();
  EXPECT_EQ(begin(), -first);
  EXPECT_GT(first, 0.0);
  window->model().change([](mien::FaceState& state) { state.surface.smoothing.fill(30.0); });
  settle();
  const double grown = end();
  EXPECT_GE(grown, first);
  window->model().change([](mien::FaceState& state) { state.surface.smoothing.fill(1.0); });
  settle();
  EXPECT_EQ(end(), grown);
  find<QToolButton>("colorAutomatic")->click();
  find<QToolButton>("colorAutomatic")->click();
  EXPECT_EQ(end(), first);
}

/// Numbers would be shown in the colours of a state that is no more.
TEST_F(FaceColoring, UndoAndRedoFitAnAutomaticRange) {
  const auto smooth = [this](double a) {
    auto* box = find<QDoubleSpinBox>("surfaceSmoothing");
    box->setFocus();
    box->setValue(a);
    window->history().act();
    settle();
    window->history().record();
  };
  choose(meanCurvature);
  window->history().clear();
  const double first = end();
  smooth(30.0);
  const double grown = end();
  ASSERT_GT(grown, first);
  window->history().undo();
  settle();
  EXPECT_EQ(end(), first);
  window->history().redo();
  settle();
  EXPECT_EQ(end(), grown);
  window->history().undo();
  settle();
  smooth(0.9);
  EXPECT_EQ(end(), first) << "and from then on it follows as before";
}

TEST_F(FaceColoring, UndoFitsTheRangeOfADifference) {
  auto* compare = find<QComboBox>("compareWith");
  compare->setCurrentIndex(1);
  emit compare->activated(1);  // with this state
  const auto express = [&](const char* expression) {
    find<QPushButton>(expression)->click();
    window->history().act();
    settle();
    window->history().record();
  };
  express("expression_sadness");
  EXPECT_TRUE(waitUntil([this] { return end() > 1.0; }));
  const double sad = end();
  express("expression_surprise");
  EXPECT_TRUE(waitUntil([&] { return end() > sad; }));
  window->history().undo();
  EXPECT_TRUE(waitUntil([&] { return end() == sad; })) << end();
}

TEST_F(FaceColoring, AFixedRangeStays) {
  choose(meanCurvature);
  find<QToolButton>("colorAutomatic")->click();
  ASSERT_TRUE(find<QDoubleSpinBox>("colorEnd")->isEnabled());
  find<QDoubleSpinBox>("colorEnd")->setValue(0.25);
  find<QDoubleSpinBox>("colorBegin")->setValue(-0.125);
  const QImage wide = picture();
  window->model().change([](mien::FaceState& state) { state.surface.smoothing.fill(30.0); });
  settle();
  EXPECT_EQ(end(), 0.25);
  EXPECT_EQ(begin(), -0.125);
  window->model().change([](mien::FaceState& state) { state.surface.smoothing.fill(1.0); });
  find<QDoubleSpinBox>("colorEnd")->setValue(0.02);
  EXPECT_NE(picture(), wide);
}

TEST_F(FaceColoring, ADockThatShowsNumbersTakesOverAndSkinEndsThat) {
  choose("Patches");
  find<QComboBox>("continuityFace")->setCurrentIndex(4);
  settle();
  EXPECT_EQ(choice()->currentText(), "Zebra stripes (Continuity dock)");
  find<QToolButton>("faceSkin")->click();
  settle();
  EXPECT_EQ(choice()->currentText(), "Skin");
  EXPECT_EQ(choice()->findText("Zebra stripes (Continuity dock)"), -1);
  find<QComboBox>("continuityFace")->setCurrentIndex(4);
  choose("Patches");
  EXPECT_EQ(find<QComboBox>("continuityFace")->currentIndex(), 0);
}

/// Whichever dock colours the face, the bar names it, and any other choice takes the face back.
TEST_F(FaceColoring, NamesTheDockThatColoursTheFace) {
  const QImage skin = picture();
  const std::vector<std::pair<QString, std::function<void()>>> docks = {
      {"Regions (Deformation dock)", [this] { find<QToolButton>("deformationRegions")->click(); }},
      {"Mode 1 (Spectrum dock)", [this] { find<QToolButton>("spectrumOnFace")->click(); }},
      {"Curvature H (Continuity dock)", [this] { find<QComboBox>("continuityFace")->setCurrentIndex(2); }},
      {"Seams (Continuity dock)", [this] { find<QComboBox>("continuityFace")->setCurrentIndex(1); }}};
  for (const char* name : {"deformationDockAction", "spectrumDockAction", "continuityDockAction"}) {
    find<QAction>(name)->trigger();
    QTest::qWait(300);
  }
  find<QComboBox>("spectrumMode")->setCurrentIndex(1);
  for (const auto& [words, show] : docks) {
    show();
    settle();
    EXPECT_EQ(choice()->currentText(), words);
    choose("Skin");
    EXPECT_EQ(choice()->findText(words), -1);
  }
  EXPECT_FALSE(find<QToolButton>("deformationRegions")->isChecked());
  EXPECT_EQ(find<QComboBox>("continuityFace")->currentIndex(), 0);
  const auto* key = find<QWidget>("colorKey");
  find<QComboBox>("continuityFace")->setCurrentIndex(2);
  settle();
  EXPECT_TRUE(key->isVisible()) << "the scale stands below the face";
  EXPECT_TRUE(key->toolTip().startsWith("Mean curvature H (1/mm)")) << key->toolTip().toStdString();
  choose("Skin");
  EXPECT_FALSE(key->isVisible());
}

TEST_F(FaceColoring, ThePhotographIsPartOfTheState) {
  choose("Photograph");
  const mien::FaceState state = window->model().state();
  EXPECT_FALSE(state.texture.empty());
  auto* view = find<FaceView>("faceView");
  EXPECT_TRUE(waitUntil([&] { return view->isTextured(); }, 20000));
  choose("Skin");
  EXPECT_TRUE(window->model().state().texture.empty());
  EXPECT_FALSE(view->isTextured());
  choose("Photograph");
  EXPECT_EQ(window->model().state(), state);
}

/// All 29 names at the view's present size, in a row of their own and inside the view.
TEST_F(FaceColoring, NamesOfCurvesDoNotOverlap) {
  find<QToolButton>("faceCurves")->click();
  find<QToolButton>("faceCurveNames")->click();
  for (const char* side : {"lookFront", "lookFortyFive", "lookSide"}) {
    find<QToolButton>(side)->click();
    picture();
    vtkRenderer* renderer = find<FaceView>("faceView")->renderer();
    std::vector<std::array<double, 4>> boxes;
    std::set<std::string> names;
    vtkActor2DCollection* actors = renderer->GetActors2D();
    actors->InitTraversal();
    while (vtkActor2D* actor = actors->GetNextActor2D())
      if (auto* name = vtkTextActor::SafeDownCast(actor)) {
        double box[4];
        name->GetBoundingBox(renderer, box);
        const double* at = name->GetPosition();
        boxes.push_back({box[0] + at[0], box[1] + at[0], box[2] + at[1], box[3] + at[1]});
        names.insert(name->GetInput());
      }
    ASSERT_EQ(names.size(), 29u);
    EXPECT_TRUE(names.count("C22'") && names.count("C1") && names.count("C28"));
    const int* size = renderer->GetSize();
    for (size_t i = 0; i < boxes.size(); ++i) {
      EXPECT_GE(boxes[i][0], 0.0) << side;
      EXPECT_LE(boxes[i][1], size[0]) << side;
      EXPECT_GE(boxes[i][2], 0.0) << side;
      EXPECT_LE(boxes[i][3], size[1]) << side;
      for (size_t k = 0; k < i; ++k)
        EXPECT_FALSE(boxes[i][0] < boxes[k][1] && boxes[k][0] < boxes[i][1] && boxes[i][2] < boxes[k][3] &&
                     boxes[k][2] < boxes[i][3])
            << side << " " << i << " " << k;
    }
  }
}

}  // namespace
