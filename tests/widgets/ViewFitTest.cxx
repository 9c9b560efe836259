#include <vtkAppendPolyData.h>
#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QPushButton>
#include <QRegularExpression>
#include <QTabBar>
#include <QTemporaryDir>
#include <QToolButton>
#include <algorithm>
#include <array>
#include <cmath>

#include "ColorKey.h"
#include "Comparison.h"
#include "ComparisonSummary.h"
#include "CurveView.h"
#include "ElidedLabel.h"
#include "FaceColoring.h"
#include "FaceModel.h"
#include "FaceView.h"
#include "ReferenceData.h"
#include "StudioFixture.h"
#include "Theme.h"
#include "ViewArea.h"

namespace {

using mien::FaceState;

class ViewFit : public StudioFixture {
 protected:
  /// The lowest and highest y, and the largest |x|, of what a view shows of a surface, from -1 to 1 within it.
  static std::array<double, 3> seen(mien::RenderView* view, vtkPolyData* surface) {
    const double aspect = static_cast<double>(view->width()) / view->height();
    vtkMatrix4x4* matrix = view->camera()->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0);
    std::array<double, 3> ends = {1e9, -1e9, 0.0};
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i) {
      double point[4] = {0.0, 0.0, 0.0, 1.0}, projected[4];
      surface->GetPoint(i, point);
      matrix->MultiplyPoint(point, projected);
      ends[0] = std::min(ends[0], projected[1] / projected[3]);
      ends[1] = std::max(ends[1], projected[1] / projected[3]);
      ends[2] = std::max(ends[2], std::abs(projected[0] / projected[3]));
    }
    return ends;
  }
  double distance(const char* view) { return find<mien::RenderView>(view)->camera()->GetDistance(); }
  void expectWhole(const std::string& what) {
    for (const char* name : {"faceView", "curveView"}) {
      const auto [low, high, aside] = seen(find<mien::RenderView>(name), surface());
      EXPECT_GT(low, -0.98) << name << ", " << what;
      EXPECT_LT(high, 0.98) << name << ", " << what;
      EXPECT_LT(aside, 0.98) << name << ", " << what;
    }
  }
  double chin() { return surface()->GetBounds()[2]; }
  void compareScheme(const char* scheme) {
    find<mien::ViewArea>("viewArea")->comparison()->compareScheme(scheme);
    settle();
  }
  static void expectUncountedWithoutNumber(vtkPolyData* drawn, double below) {
    vtkDataArray* distances = drawn->GetPointData()->GetArray("Distance");
    ASSERT_TRUE(distances);
    int without = 0;
    for (vtkIdType i = 0; i < drawn->GetNumberOfPoints(); ++i) {
      const bool isUncounted = drawn->GetPoint(i)[1] < below;
      without += isUncounted;
      ASSERT_EQ(std::isnan(distances->GetComponent(i, 0)), isUncounted) << i;
    }
    EXPECT_GT(without, 300);
  }
  void expectWholeSummary(const char* name, const char* pattern) {
    const auto* label = find<mien::ComparisonSummary>(name);
    EXPECT_TRUE(label->summary().contains(QRegularExpression(pattern))) << label->summary().toStdString();
    QString shown = label->text();
    EXPECT_EQ(shown.replace('\n', ' ').toStdString(), label->summary().toStdString());
    const QSize needed = label->fontMetrics().size(0, label->text());
    EXPECT_LE(needed.width(), label->contentsRect().width()) << label->text().toStdString();
    EXPECT_LE(needed.height(), label->contentsRect().height()) << label->text().toStdString();
  }
  /// How many pixels are free between the edges of a view and what it shows of a head above the chin: at the sides and
  /// at the top.
  std::array<double, 2> freeAround(vtkPolyData* head, mien::RenderView* view) {
    vtkNew<vtkPoints> points;
    for (vtkIdType i = 0; i < head->GetNumberOfPoints(); ++i)
      if (head->GetPoint(i)[1] > chin()) points->InsertNextPoint(head->GetPoint(i));
    vtkNew<vtkPolyData> above;
    above->SetPoints(points);
    const auto [low, high, aside] = seen(view, above);
    return {0.5 * view->width() * (1.0 - aside), 0.5 * view->height() * (1.0 - high)};
  }
  QStringList cutTitles() {
    QStringList cut;
    for (auto* label : find<QWidget>("viewArea")->findChildren<mien::ElidedLabel*>())
      if (label->isVisible() && label->property("heading").toBool() && label->shownText() != label->text())
        cut << label->shownText() + " of " + label->text();
    return cut;
  }
};

/// Without a key a view reaches the lower edge of its frame; a key covers a band that is told from the view.
TEST_F(ViewFit, TheSceneReachesTheLowerEdgeWhereNoKeyStands) {
  auto* face = find<mien::FaceView>("faceView");
  auto* key = find<mien::ViewArea>("viewArea")->coloring()->key();
  EXPECT_FALSE(key->isVisible());
  EXPECT_LE(face->parentWidget()->height() - face->geometry().bottom() - 1, 2) << "the frame's line alone is below";
  face->placeCamera({0, 0, 60}, {0, 0, 1}, 400.0);
  for (const auto kind : {mien::Theme::Kind::Light, mien::Theme::Kind::Dark}) {
    mien::Theme::apply(kind, *qApp);
    face->useTheme();
    find<QComboBox>("colorBy")->setCurrentText("Skin");
    settle();
    const QImage bare = face->grab().toImage();
    EXPECT_NE(bare.pixel(bare.width() / 2, bare.height() - 3), bare.pixel(2, bare.height() - 3)) << "the neck goes on";
    find<QComboBox>("colorBy")->setCurrentText("Patches");
    settle();
    ASSERT_TRUE(key->isVisible());
    EXPECT_EQ(key->mapTo(window.get(), QPoint(0, key->height())), face->mapTo(window.get(), QPoint(0, face->height())));
    const QImage band = key->grab().toImage();
    EXPECT_EQ(band.pixelColor(2, 0).name(), mien::Theme::current().line.name());
    EXPECT_EQ(band.pixelColor(2, 4).name(), mien::Theme::current().panel.name());
  }
  mien::Theme::apply(mien::Theme::Kind::Light, *qApp);
}

/// With as much room above as below, up to where a key may stand.
TEST_F(ViewFit, TheFaceStandsInTheMiddleOfWhatNoKeyCovers) {
  for (const QSize size : {QSize(1000, 700), QSize(1280, 800), QSize(2560, 1440)}) {
    window->resize(size);
    settle();
    for (const char* name : {"faceView", "curveView"}) {
      const auto* view = find<mien::RenderView>(name);
      const auto [low, high, aside] = seen(find<mien::RenderView>(name), surface());
      const double above = 0.5 * view->height() * (1.0 - high);
      const double below = 0.5 * view->height() * (low + 1.0) - view->foot();
      RecordProperty(name + std::to_string(size.width()), std::to_string(above) + " " + std::to_string(below));
      EXPECT_NEAR(above, below, 0.02 * view->height()) << name << " " << size.width();
    }
  }
}

/// Expressions never move the camera; the jaw as far as its slider goes moves it once, and is whole.
TEST_F(ViewFit, TheOpenJawIsWithinBothViews) {
  const double height = surface()->GetBounds()[3] - surface()->GetBounds()[2], atRest = chin();
  const double face = distance("faceView"), curves = distance("curveView");
  for (const char* expression : {"joy", "sadness", "anger", "fear", "disgust", "surprise"}) {
    window->model().change([&](FaceState& state) { state.expressions = {{expression, 1.0}}; });
    settle();
    expectWhole(expression);
    EXPECT_EQ(distance("faceView"), face) << expression;
    EXPECT_EQ(distance("curveView"), curves) << expression;
    EXPECT_LT((atRest - chin()) / height, 0.10) << expression;
  }
  window->model().change([](FaceState& state) {
    state.expressions.clear();
    state.fapValues[3] = 1024;
  });
  settle();
  expectWhole("FAP 3");
  RecordProperty("jawShare", std::to_string((atRest - chin()) / height));
  EXPECT_GT((atRest - chin()) / height, 0.05);
  for (const char* side : {"lookFortyFive", "lookSide", "lookReset"}) {
    find<QToolButton>(side)->click();
    settle();
    expectWhole(side);
  }
}

TEST_F(ViewFit, TheFaceAtRestIsNotSmall) {
  const auto [low, high, aside] = seen(find<mien::RenderView>("faceView"), surface());
  EXPECT_TRUE(high - low > 2.0 * 0.75 || aside > 0.8) << low << " " << high << " " << aside;
}

/// Linked views show the face equally large, whatever it is coloured by.
TEST_F(ViewFit, TheFaceAndItsCurvesAreOfOneScale) {
  const auto *face = find<mien::RenderView>("faceView"), *curves = find<mien::RenderView>("curveView");
  for (const QSize size : {QSize(1000, 700), QSize(1280, 800), QSize(2560, 1440)}) {
    window->resize(size);
    settle();
    const double before = distance("faceView");
    for (const char* color : {"Mean curvature H (1/mm)", "Patches", "Skin"}) {
      find<QComboBox>("colorBy")->setCurrentText(color);
      settle();
      EXPECT_EQ(face->height(), curves->height()) << color << ", " << size.width();
      EXPECT_NEAR(face->width(), curves->width(), 1) << color << ", " << size.width();
      EXPECT_NEAR(distance("faceView") / distance("curveView"), 1.0, 0.005) << color << ", " << size.width();
      EXPECT_EQ(distance("faceView"), before) << color << ", " << size.width();
    }
  }
}

/// Whatever waits behind "more", the way back does not.
TEST_F(ViewFit, AComparisonCanAlwaysBeClosed) {
  for (const QSize size : {QSize(1280, 800), QSize(1000, 700)}) {
    window->resize(size);
    compareScheme("tangent");
    const auto* close = find<QToolButton>("compareClear");
    EXPECT_TRUE(close->isVisible()) << size.width();
    EXPECT_GE(close->width(), close->sizeHint().width());
    find<mien::ViewArea>("viewArea")->comparison()->clear();
  }
}

/// Titles say which is which: buttons leave first. Numbers keep their unit, and what they are of.
TEST_F(ViewFit, TitlesAndNumbersAreWhole) {
  for (const QSize size : {QSize(2560, 1440), QSize(1280, 800), QSize(1000, 700)}) {
    window->resize(size);
    settle();
    EXPECT_EQ(cutTitles().join("; ").toStdString(), "");
    window->model().change([](FaceState& state) { state.expressions = {{"joy", 1.0}}; });
    compareScheme("four-curve");
    EXPECT_EQ(cutTitles().join("; ").toStdString(), "");
    EXPECT_EQ(find<mien::ViewArea>("viewArea")->comparison()->name(), "four-curve, joy");
    expectWholeSummary("compareSummaryA",
                       "^Point to point, by area of A: RMS [0-9.]+, 95 % \u2264 [0-9.]+, max [0-9.]+ mm$");
    expectWholeSummary("compareSummaryB",
                       "^Point to point, by area of B: RMS [0-9.]+, 95 % \u2264 [0-9.]+, max [0-9.]+ mm$");
    EXPECT_EQ(find<QWidget>("compareSummaryA")->height(), find<QWidget>("compareSummaryB")->height());
    for (const auto* key : find<QWidget>("viewArea")->findChildren<mien::ColorKey*>()) {
      if (key->isVisible()) {
        EXPECT_EQ(key->shownTitle(), "Difference A\u2013B (mm)") << size.width();
      }
    }
    find<mien::ViewArea>("viewArea")->comparison()->clear();
    settle();
  }
}

/// A long title takes their room, and a short one gives it back.
TEST_F(ViewFit, ButtonsComeBackAfterAComparison) {
  window->resize(1280, 800);
  settle();
  auto* more = find<QToolButton>("faceViewHeaderMore");
  ASSERT_FALSE(more->isVisible());
  compareScheme("four-curve");
  ASSERT_TRUE(waitUntil([&] { return more->isVisible(); }));
  find<mien::ViewArea>("viewArea")->comparison()->clear();
  EXPECT_TRUE(waitUntil([&] { return !more->isVisible(); }));
}

/// What of a head lies opposite the face is as large as the face alone would be; its neck has no number and is grey.
TEST_F(ViewFit, TheFaceOfAHeadIsLargeAndItsNeckIsNotCounted) {
  vtkNew<vtkPlaneSource> neck;
  neck->SetOrigin(-60.0, chin() - 90.0, 0.0);
  neck->SetPoint1(60.0, chin() - 90.0, 0.0);
  neck->SetPoint2(-60.0, chin() - 20.0, 0.0);
  neck->SetResolution(20, 20);
  neck->Update();
  vtkNew<vtkPolyData> face;
  face->CopyStructure(surface());
  vtkNew<vtkAppendPolyData> head;
  head->AddInputData(face);
  head->AddInputData(neck->GetOutput());
  QTemporaryDir folder;
  const QString file = folder.filePath("subject01_neutral.vtp");
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(file.toUtf8().constData());
  writer->SetInputConnection(head->GetOutputPort());
  ASSERT_TRUE(writer->Write());
  auto* comparison = find<mien::ViewArea>("viewArea")->comparison();
  ASSERT_TRUE(comparison->openMesh(file));
  ASSERT_TRUE(waitUntil([&] { return comparison->surface(mien::Comparison::Side::B) != nullptr; }));
  settle();
  const auto [low, high, aside] = seen(find<mien::RenderView>("otherFaceView"), surface());
  EXPECT_GT(low, -1.0);
  EXPECT_LT(high, 1.0);
  EXPECT_LT(aside, 1.0);
  EXPECT_TRUE(high - low > 2.0 * 0.75 || aside > 0.8) << low << " " << high << " " << aside;
  EXPECT_EQ(distance("otherFaceView"), distance("faceView"));
  expectUncountedWithoutNumber(comparison->drawn(mien::Comparison::Side::B), chin() - 15.0);
  const QString summary = comparison->summary(mien::Comparison::Side::B);
  EXPECT_TRUE(summary.startsWith("B to A, ")) << summary.toStdString();
  EXPECT_TRUE(summary.endsWith(" % of B: RMS 0.00, 95 % \u2264 0.00, max 0.00 mm")) << summary.toStdString();
  EXPECT_EQ(cutTitles().join("; ").toStdString(), "");
  const double withHead = distance("faceView");
  compareScheme("tangent");
  EXPECT_EQ(distance("faceView"), withHead);
}

/// Crown and ears are within the view, whatever of the neck is; A stays large.
TEST_F(ViewFit, CrownAndEarsOfAHeadAreWithinTheView) {
  auto* comparison = find<mien::ViewArea>("viewArea")->comparison();
  auto* a = find<mien::RenderView>("faceView");
  for (const char* subject : {"01", "03", "05"}) {
    const std::string file = referencePath(std::string("heads/subject") + subject + "_neutral.ply");
    MIEN_REQUIRE_REFERENCE(std::string("heads/subject") + subject + "_neutral.ply");
    for (const QSize size : {QSize(1280, 800), QSize(1000, 700), QSize(2560, 1440)}) {
      const std::string what = subject + (" at " + std::to_string(size.width()));
      window->resize(size);
      settle();
      ASSERT_TRUE(comparison->openMesh(QString::fromStdString(file)));
      ASSERT_TRUE(waitUntil([&] { return comparison->surface(mien::Comparison::Side::B) != nullptr; }, 20000));
      settle();
      for (const char* side : {"lookSide", "lookFortyFive", "lookFront"}) {
        find<QToolButton>(side)->click();
        settle();
        const auto [aside, above] = freeAround(comparison->mesh(), find<mien::RenderView>("otherFaceView"));
        EXPECT_GE(aside, 8.0) << what << ", " << side;
        EXPECT_GE(above, 8.0) << what << ", " << side;
        EXPECT_EQ(distance("otherFaceView"), distance("faceView")) << what;
      }
      const double width = seen(a, surface())[2] * a->width();
      if (size.width() == 1280) {
        EXPECT_GE(width, 300.0) << what;
      }
      if (subject == std::string("03")) expectWholeSummary("compareSummaryA", "^A to B, [0-9]+ % of A: RMS .* mm$");
      comparison->clear();
    }
  }
}

/// With their keys, numbers and a timeline below them, and the highest dock.
TEST_F(ViewFit, ComparedFacesAreMoreThanABlotInTheSmallestWindow) {
  window->resize(960, 660);
  find<QTabBar>("workspaces")->setCurrentIndex(2);
  ASSERT_TRUE(window->openAnimation(writeLids(10, 25)));
  auto* compare = find<QComboBox>("compareWith");
  compare->setCurrentIndex(1);
  emit compare->activated(1);
  find<QPushButton>("expression_sadness")->click();
  settle();
  EXPECT_EQ(window->size(), QSize(960, 660));
  for (const char* name : {"faceView", "otherFaceView"}) {
    const auto* view = find<mien::RenderView>(name);
    EXPECT_GE(view->freeHeight(), 100) << name;
  }
  find<QToolButton>("faceScan")->show();  // as with a scan
  settle();
  EXPECT_EQ(window->size(), QSize(960, 660));
}

}  // namespace
