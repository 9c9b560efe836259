#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkMotionVectorFilter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSurfaceDistanceFilter.h>
#include <vtkXMLPolyDataWriter.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QSplitter>
#include <QTemporaryDir>
#include <QToolButton>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "BackgroundTask.h"
#include "Comparison.h"
#include "DifferenceArrows.h"
#include "FaceModel.h"
#include "FaceView.h"
#include "StudioFixture.h"
#include "ViewArea.h"

namespace {

using mien::FaceState;
using Kind = mien::Comparison::Kind;
using Side = mien::Comparison::Side;

class Comparison : public StudioFixture {
 protected:
  mien::Comparison* comparison() { return find<mien::ViewArea>("viewArea")->comparison(); }
  QComboBox* choice() { return find<QComboBox>("compareWith"); }
  void choose(int index) {
    choice()->setCurrentIndex(index);
    emit choice()->activated(index);
    settle();
  }
  void smile() {
    window->model().change([](FaceState& state) { state.expressions["joy"] = 1.0; });
    settle();
  }
  /// As a file without any arrays.
  void openMeshOfA() {
    QTemporaryDir folder;
    const QString file = folder.filePath("joy.vtp");
    vtkNew<vtkPolyData> bare;
    bare->CopyStructure(surface());
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetFileName(file.toUtf8().constData());
    writer->SetInputData(bare);
    EXPECT_TRUE(writer->Write());
    EXPECT_TRUE(comparison()->openMesh(file)) << message().toStdString();
    settle();
  }
  vtkPolyData* measured(Side side) {
    EXPECT_TRUE(waitUntil([&] { return comparison()->surface(side) != nullptr; }));
    return comparison()->surface(side);
  }
  static vtkDataArray* array(vtkDataObject* surface, const char* name) {
    return vtkPolyData::SafeDownCast(surface)->GetPointData()->GetArray(name);
  }
  static void expectSameBits(vtkDataArray* one, vtkDataArray* other) {
    ASSERT_TRUE(one && other);
    ASSERT_EQ(one->GetDataType(), other->GetDataType());
    ASSERT_EQ(one->GetNumberOfValues(), other->GetNumberOfValues());
    EXPECT_EQ(std::memcmp(one->GetVoidPointer(0), other->GetVoidPointer(0),
                          one->GetNumberOfValues() * one->GetDataTypeSize()),
              0);
  }
};

constexpr int nothing = 0, thisState = 1;

/// A scan in metres, centimetres or inches compared as if it were in mm.
TEST_F(Comparison, AMeshInAnotherUnitIsDoubted) {
  openMeshOfA();
  EXPECT_EQ(message(), "");
  const QTemporaryDir folder;
  for (const auto& [unit, scale] :
       {std::pair<const char*, double>{"metres", 1e-3}, {"centimetres", 0.1}, {"inches", 1 / 25.4}}) {
    vtkNew<vtkPolyData> scaled;
    scaled->DeepCopy(surface());
    for (vtkIdType i = 0; i < scaled->GetNumberOfPoints(); ++i) {
      double p[3];
      scaled->GetPoint(i, p);
      scaled->GetPoints()->SetPoint(i, scale * p[0], scale * p[1], scale * p[2]);
    }
    vtkNew<vtkXMLPolyDataWriter> writer;
    const QString file = folder.filePath("scaled.vtp");
    writer->SetFileName(file.toUtf8().constData());
    writer->SetInputData(scaled);
    ASSERT_TRUE(writer->Write());
    comparison()->openMesh(file);
    EXPECT_TRUE(message().contains(QString("it may be in ") + unit)) << message().toStdString();
  }
}

/// What was chosen is a command; the list then says what came of it.
TEST_F(Comparison, TheListSaysWithWhatTheFaceIsCompared) {
  const int entries = choice()->count();
  EXPECT_EQ(choice()->currentText(), "Nothing");
  choose(thisState);
  EXPECT_EQ(choice()->currentText(), "Kept: the neutral face");
  smile();
  EXPECT_EQ(choice()->currentText(), "Kept: the neutral face");
  choose(thisState);
  EXPECT_EQ(choice()->currentText(), "Kept: " + QString::fromStdString(window->model().motionText()));
  openMeshOfA();
  EXPECT_EQ(choice()->currentText(), "joy.vtp");
  EXPECT_EQ(choice()->count(), entries + 1);
  comparison()->compareScheme("four-curve");
  EXPECT_EQ(choice()->currentText(), "Scheme four-curve");
  choose(nothing);
  EXPECT_EQ(choice()->currentText(), "Nothing");
  EXPECT_EQ(choice()->count(), entries);
}

/// A pinned neutral face against joy: the same mesh, so the difference is that of the points, to the bit.
TEST_F(Comparison, OfOneMeshIsTheDifferenceOfItsPoints) {
  choose(thisState);
  EXPECT_EQ(comparison()->kind(), Kind::State);
  smile();
  ASSERT_TRUE(comparison()->corresponds());
  vtkPolyData *a = measured(Side::A), *b = measured(Side::B);
  ASSERT_EQ(a->GetNumberOfPoints(), surface()->GetNumberOfPoints());
  double largest = 0.0;
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i) {
    double p[3], q[3];
    a->GetPoint(i, p);
    b->GetPoint(i, q);
    for (int k = 0; k < 3; ++k) {
      ASSERT_EQ(array(b, "DistanceVector")->GetComponent(i, k), p[k] - q[k]) << i;
      ASSERT_EQ(array(a, "DistanceVector")->GetComponent(i, k), q[k] - p[k]) << i;
    }
    largest = std::max(largest, array(a, "Distance")->GetComponent(i, 0));
  }
  EXPECT_GT(largest, 3.0);
  vtkNew<vtkMotionVectorFilter> filter;
  filter->SetInputData(surface());
  filter->SetNeutralData(comparison()->other()->pipeline().surface()->GetOutputDataObject(0));
  filter->Update();
  EXPECT_EQ(filter->GetLargestMagnitude(), largest);
  expectSameBits(array(b, "Distance"), array(filter->GetOutputDataObject(0), "Magnitude"));
}

/// Another resolution has no counterparts: distances to the nearest point, as mien compare measures them.
TEST_F(Comparison, OfTwoMeshesIsTheDistanceOfTheirSurfaces) {
  window->model().change([](FaceState& state) { state.rows = 83; });
  settle();
  choose(thisState);
  window->model().change([](FaceState& state) { state.rows = 56; });
  smile();
  ASSERT_TRUE(waitUntil([&] { return comparison()->surface(Side::A) && !comparison()->summary(Side::A).isEmpty(); }));
  vtkNew<vtkSurfaceDistanceFilter> filter;
  filter->SetInputData(surface());
  filter->SetReferenceData(comparison()->other()->pipeline().surface()->GetOutputDataObject(0));
  filter->GenerateVectorsOn();
  filter->Update();
  const auto isPresent = [&] {
    vtkDataArray* shown = array(comparison()->surface(Side::A), "Distance");
    return shown->GetMaxNorm() == filter->GetMaximumDistance(0);
  };
  ASSERT_TRUE(waitUntil(isPresent));
  EXPECT_FALSE(comparison()->corresponds());
  for (int side = 0; side < 2; ++side)
    for (const char* name : {"Distance", "DistanceVector"})
      expectSameBits(array(comparison()->surface(static_cast<Side>(side)), name),
                     array(filter->GetOutputDataObject(side), name));
}

/// What is still being measured of another mesh is not shown in place of the counterparts' distances.
TEST_F(Comparison, CounterpartsAreNotOvertakenByOlderWork) {
  choose(thisState);
  window->model().change([](FaceState& state) { state.rows = 83; });
  ASSERT_TRUE(window->model().update());  // measured to the nearest points, on a thread of its own
  auto* task = comparison()->findChild<mien::BackgroundTask*>();
  ASSERT_TRUE(task->isRunning());
  window->model().change([](FaceState& state) { state.rows = 56; });
  ASSERT_TRUE(window->model().update());
  ASSERT_TRUE(comparison()->corresponds());
  vtkPolyData* counterparts = comparison()->surface(Side::A);
  EXPECT_TRUE(waitUntil([&] { return !task->isRunning(); }));
  EXPECT_TRUE(comparison()->corresponds());
  EXPECT_EQ(comparison()->surface(Side::A), counterparts);
}

TEST_F(Comparison, OfASchemeFollowsTheFace) {
  choose(choice()->findData("four-curve"));
  EXPECT_EQ(comparison()->kind(), Kind::Scheme);
  const double before = array(measured(Side::A), "Distance")->GetMaxNorm();
  EXPECT_GT(before, 0.1);
  smile();
  FaceState expected = window->model().state();
  expected.surface.scheme = "four-curve";
  EXPECT_EQ(comparison()->other()->state(), expected);
  EXPECT_NE(array(measured(Side::A), "Distance")->GetMaxNorm(), before);
  window->model().change([](FaceState& state) { state.surface.scheme = "four-curve"; });
  settle();
  EXPECT_EQ(array(measured(Side::A), "Distance")->GetMaxNorm(), 0.0);
}

TEST_F(Comparison, WithAFileOfTheSameFaceIsZero) {
  smile();
  openMeshOfA();
  EXPECT_EQ(comparison()->kind(), Kind::Mesh);
  EXPECT_EQ(array(measured(Side::A), "Distance")->GetMaxNorm(), 0.0);
  EXPECT_FALSE(find<QToolButton>("compareSwap")->isEnabled());
  EXPECT_GT(colorsIn("otherFaceView"), 50);
}

TEST_F(Comparison, AFileThatIsNoSurfaceChangesNothing) {
  QTemporaryDir folder;
  QFile file(folder.filePath("broken.ply"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("ply\nformat ascii 1.0\nelement vertex 3\n");
  file.close();
  EXPECT_FALSE(comparison()->openMesh(file.fileName()));
  settle();
  EXPECT_EQ(comparison()->kind(), Kind::None);
  EXPECT_TRUE(message().contains("broken.ply")) << message().toStdString();
  EXPECT_FALSE(window->findChild<QWidget*>("otherFaceView"));
}

TEST_F(Comparison, SwapExchangesTheStates) {
  const FaceState neutral = window->model().state();
  choose(thisState);
  smile();
  const FaceState joy = window->model().state();
  find<QToolButton>("compareSwap")->click();
  settle();
  EXPECT_EQ(window->model().state(), neutral);
  EXPECT_EQ(comparison()->other()->state(), joy);
  find<QToolButton>("compareSwap")->click();
  settle();
  EXPECT_EQ(window->model().state(), joy);
  EXPECT_EQ(comparison()->other()->state(), neutral);
  choose(choice()->findData("tangent"));
  find<QToolButton>("compareSwap")->click();
  settle();
  EXPECT_EQ(window->model().state().surface.scheme, "tangent");
  EXPECT_EQ(comparison()->scheme(), QString::fromStdString(joy.surface.scheme));
}

TEST_F(Comparison, ClosingItShowsTheCurvesAndTheSkinAgain) {
  auto* curves = find<QWidget>("curveView");
  choose(thisState);
  EXPECT_TRUE(find<QWidget>("otherFaceView")->isVisible());
  EXPECT_FALSE(curves->isVisible());  // no room for three in this window
  EXPECT_EQ(find<QComboBox>("colorBy")->currentText(), "Difference A\u2013B (mm)");
  find<QToolButton>("compareClear")->click();
  settle();
  EXPECT_EQ(comparison()->kind(), Kind::None);
  EXPECT_FALSE(find<QWidget>("otherFaceView")->isVisible());
  EXPECT_TRUE(curves->isVisible());
  EXPECT_EQ(find<QComboBox>("colorBy")->currentText(), "Skin");
  EXPECT_EQ(find<QComboBox>("colorBy")->findText("Difference A\u2013B (mm)"), -1);
  EXPECT_EQ(choice()->currentIndex(), nothing);
}

TEST_F(Comparison, CamerasOfAllViewsAreLinked) {
  choose(thisState);
  find<QToolButton>("lookFortyFive")->click();
  settle();
  double a[3], direction[3];
  find<mien::FaceView>("faceView")->camera()->GetDirectionOfProjection(a);
  for (const char* view : {"otherFaceView", "curveView"}) {
    find<mien::RenderView>(view)->camera()->GetDirectionOfProjection(direction);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(direction[i], a[i], 1e-12) << view;
  }
  find<mien::FaceView>("otherFaceView")->placeCamera({0, 0, 60}, {1, 0, 0}, 500.0);
  for (const char* view : {"faceView", "curveView"}) {
    find<mien::RenderView>(view)->camera()->GetDirectionOfProjection(direction);
    EXPECT_NEAR(direction[0], -1.0, 1e-12) << view;
  }
  find<QToolButton>("compareLink")->click();
  find<QToolButton>("lookFront")->click();
  settle();
  find<mien::FaceView>("otherFaceView")->placeCamera({0, 0, 60}, {1, 0, 0}, 500.0);
  find<mien::FaceView>("faceView")->camera()->GetDirectionOfProjection(direction);
  EXPECT_NEAR(direction[2], -1.0, 1e-12);
}

TEST_F(Comparison, ArrowsLeadFromEachFaceToTheOther) {
  choose(thisState);
  smile();
  const auto arrows = find<mien::ViewArea>("viewArea")->findChildren<mien::DifferenceArrows*>();
  ASSERT_EQ(arrows.size(), 2);
  for (const mien::DifferenceArrows* one : arrows) EXPECT_EQ(one->count(), 0);
  auto* choice = find<QComboBox>("compareArrows");
  const QImage without = find<QWidget>("otherFaceView")->grab().toImage();
  choice->setCurrentIndex(2);
  settle();
  for (const mien::DifferenceArrows* one : arrows) {
    EXPECT_GT(one->count(), 100);
    EXPECT_EQ(one->factor(), 2.0);
  }
  EXPECT_NE(find<QWidget>("otherFaceView")->grab().toImage(), without);
  window->model().change([](FaceState& state) { state.expressions.clear(); });
  settle();
  for (const mien::DifferenceArrows* one : arrows) EXPECT_EQ(one->count(), 0);
}

TEST_F(Comparison, BothSidesAreColouredAlike) {
  choose(thisState);
  find<QComboBox>("colorBy")->setCurrentText("Mean curvature H (1/mm)");
  settle();
  vtkDataObject* other = comparison()->other()->pipeline().surface()->GetOutputDataObject(0);
  expectSameBits(array(other, "MeanCurvature"), array(surface(), "MeanCurvature"));
  find<QComboBox>("colorBy")->setCurrentText("Patches");
  settle();
  EXPECT_GT(colorsIn("otherFaceView"), 200);
}

TEST_F(Comparison, ASessionBringsBack) {
  using nlohmann::json;
  smile();
  choose(thisState);
  const json pinned = comparison()->sessionState();
  const FaceState joy = comparison()->other()->state();
  choose(choice()->findData("sixth-order"));
  const json scheme = comparison()->sessionState();
  choose(nothing);
  const json none = comparison()->sessionState();
  comparison()->restoreSession(pinned);
  EXPECT_EQ(comparison()->sessionState(), pinned);
  EXPECT_EQ(comparison()->other()->state(), joy);
  comparison()->restoreSession(scheme);
  EXPECT_EQ(comparison()->sessionState(), scheme);
  EXPECT_EQ(choice()->currentData().toString(), "sixth-order");
  comparison()->restoreSession({{"kind", "state"}, {"state", {{"mien_face_state", "old"}}}});
  settle();
  EXPECT_NE(message(), "");
  EXPECT_EQ(comparison()->sessionState(), scheme);
  comparison()->restoreSession(none);
  EXPECT_EQ(comparison()->kind(), Kind::None);
}

/// A millimetre is as many pixels in A as in B, and both stand at one height, however wide each of them is and whatever
/// they show below.
TEST_F(Comparison, BothFacesAreOfOneScale) {
  smile();
  choose(thisState);
  auto *a = find<mien::FaceView>("faceView"), *b = find<mien::FaceView>("otherFaceView");
  auto* splitter = find<QSplitter>("viewSplitter");
  const auto expectAlike = [&](const std::string& what) {
    settle();
    EXPECT_EQ(a->height(), b->height()) << what;
    EXPECT_EQ(a->mapTo(window.get(), QPoint()).y(), b->mapTo(window.get(), QPoint()).y()) << what;
    EXPECT_NEAR(a->height() / a->camera()->GetDistance(), b->height() / b->camera()->GetDistance(), 1e-9) << what;
  };
  for (const QSize size : {QSize(1280, 800), QSize(1900, 1100)}) {
    window->resize(size);
    settle();
    for (int share : {300, 450, 700}) {
      splitter->setSizes({share, 900 - share, 100});
      expectAlike(std::to_string(size.width()) + ", A has " + std::to_string(share));
    }
  }
  a->placeCamera({0, 20, 60}, {0, 0, 1}, 400.0);
  expectAlike("near");
  splitter->setSizes({250, 650, 100});
  expectAlike("near, A narrow");
  a->fit();
  openMeshOfA();
  expectAlike("a mesh");
  for (const char* color : {"Mean curvature H (1/mm)", "Patches", "Skin"}) {
    find<QComboBox>("colorBy")->setCurrentText(QString::fromUtf8(color));
    expectAlike(color);
  }
  find<QComboBox>("continuityFace")->setCurrentIndex(2);  // of A alone
  expectAlike("curvature of a dock");
}

/// Every control of the views lies within its frame, with all of its text.
TEST_F(Comparison, FitsIntoASmallScreen) {
  choose(thisState);
  find<QComboBox>("colorBy")->setCurrentText("Gaussian curvature K (1/mm\u00b2)");
  settle();
  EXPECT_LE(window->minimumSizeHint().width(), 1280);
  auto* area = find<QWidget>("viewArea");
  for (QWidget* control : area->findChildren<QWidget*>()) {
    if (!control->isVisible() || control->objectName().isEmpty()) continue;
    const QRect place(control->mapTo(area, QPoint()), control->size());
    EXPECT_TRUE(area->rect().contains(place)) << control->objectName().toStdString();
    if (qobject_cast<QToolButton*>(control)) {
      EXPECT_GE(control->width(), control->sizeHint().width()) << control->objectName().toStdString();
    }
  }
}

}  // namespace
