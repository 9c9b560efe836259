#include <vtkAlgorithm.h>
#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMimeData>
#include <QPushButton>
#include <QTemporaryDir>
#include <QToolButton>
#include <QUrl>
#include <array>
#include <cmath>
#include <map>

#include "ColorScale.h"
#include "Comparison.h"
#include "CurveView.h"
#include "FAPText.h"
#include "FaceModel.h"
#include "StudioFixture.h"
#include "Theme.h"
#include "ViewArea.h"

namespace {

using StudioWindow = StudioFixture;
using mien::CurveView;
using mien::FaceView;

std::array<double, 3> direction(mien::RenderView* view) {
  std::array<double, 3> out;
  view->camera()->GetDirectionOfProjection(out.data());
  return out;
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

TEST_F(StudioWindow, EveryMeshStyleLooksDifferent) {
  auto* view = find<FaceView>("faceView");
  auto* mesh = find<QComboBox>("faceMesh");
  std::vector<QImage> pictures;
  for (int style = 0; style < mesh->count(); ++style) {
    mesh->setCurrentIndex(style);
    settle();
    pictures.push_back(view->grab().toImage());
    for (int other = 0; other < style; ++other) EXPECT_NE(pictures[style], pictures[other]) << style << " " << other;
  }
  EXPECT_EQ(pictures.size(), 4u);
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
  drawViews();
  auto* face = find<FaceView>("faceView");
  auto* curves = find<CurveView>("curveView");
  const auto before = direction(face);
  drag(face, face->rect().center(), {80, 30});
  EXPECT_LT(vtkMath::Dot(before.data(), direction(face).data()), 0.99);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(direction(curves)[i], direction(face)[i], 1e-12);
  drag(curves, curves->rect().center(), {-60, 10});
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(direction(curves)[i], direction(face)[i], 1e-12);
  QTest::mouseClick(find<QToolButton>("lookReset"), Qt::LeftButton);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(direction(face)[i], before[i], 1e-12);
}

TEST_F(StudioWindow, AnUnlinkedViewKeepsItsOwnCamera) {
  auto* face = find<FaceView>("faceView");
  auto* curves = find<CurveView>("curveView");
  QTest::mouseClick(find<QToolButton>("curveLink"), Qt::LeftButton);
  const auto before = direction(curves);
  drag(face, face->rect().center(), {80, 30});
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

/// Whether a view shows all of the curves as they are now.
bool holdsTheCurves(mien::RenderView* view, mien::FaceModel& model) {
  auto* curves = vtkPolyData::SafeDownCast(model.pipeline().curves()->GetOutputDataObject(0));
  for (vtkIdType i = 0; i < curves->GetNumberOfPoints(); ++i) {
    double x = curves->GetPoint(i)[0], y = curves->GetPoint(i)[1], z = curves->GetPoint(i)[2];
    view->renderer()->WorldToView(x, y, z);
    if (std::abs(x) > 1.0 || std::abs(y) > 1.0) return false;
  }
  return true;
}

TEST_F(StudioWindow, AWideOpenJawAndATurnedHeadStayInTheViews) {
  auto* face = find<FaceView>("faceView");
  auto* curves = find<CurveView>("curveView");
  const double before = face->camera()->GetDistance();
  for (const char* side : {"lookFront", "lookFortyFive", "lookSide"}) {
    find<QToolButton>(side)->click();
    window->model().change([](mien::FaceState& state) {
      state.fapValues[3] = 1000.0;
      state.fapValues[48] = 40000.0;
    });
    settle();
    EXPECT_TRUE(holdsTheCurves(face, window->model())) << side;
    EXPECT_TRUE(holdsTheCurves(curves, window->model())) << side;
  }
  find<QAction>("actionNeutral")->trigger();
  find<QToolButton>("lookFront")->click();
  settle();
  EXPECT_NEAR(face->camera()->GetDistance(), before, 1e-6 * before) << "a face at rest fills the view again";
}

TEST_F(StudioWindow, TheViewHoldsAWholeAnimationFromTheStart) {
  auto* face = find<FaceView>("faceView");
  const QString name = QDir::temp().filePath(QString("mien_nod_%1.fap").arg(QCoreApplication::applicationPid()));
  QFile file(name);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("2.1 nod 25 9\n");
  for (int i = 0; i < 9; ++i)
    file.write(QString("%1\n%2 %3\n").arg(QString::fromStdString(maskText({48}))).arg(i).arg(10000 * i).toUtf8());
  file.close();
  ASSERT_TRUE(window->openAnimation(name));
  settle();
  const double distance = face->camera()->GetDistance();
  for (int i = 0; i < 9; ++i) {
    window->model().showFrame(i);
    ASSERT_TRUE(window->model().update());
    EXPECT_TRUE(holdsTheCurves(face, window->model())) << i;
    EXPECT_EQ(face->camera()->GetDistance(), distance) << i;
  }
  file.remove();
}

TEST_F(StudioWindow, TheColourScaleTellsWhatLiesBeyondIt) {
  auto* scale = find<mien::ColorScale>("curveScale");
  auto* view = find<CurveView>("curveView");
  auto* range = find<QDoubleSpinBox>("curveRange");
  EXPECT_EQ(view->most(), 0.0);
  EXPECT_EQ(range->text(), "auto 2 mm");
  window->model().change([](mien::FaceState& state) { state.fapValues[3] = 1000.0; });
  settle();
  EXPECT_EQ(view->most(), largestDisplacement());
  EXPECT_GE(view->rangeEnd(), view->most());
  EXPECT_LE(view->rangeEnd(), 2.5 * view->most());
  EXPECT_FALSE(scale->isExceeded()) << "the range grows with the movement";
  EXPECT_GT(view->rangeEnd(), 2.0);
  window->model().change([](mien::FaceState& state) { state.fapValues[3] = 10.0; });
  settle();
  EXPECT_EQ(range->text(), "auto 2 mm") << "whatever was shown before";
  range->setValue(0.1);
  settle();
  EXPECT_EQ(view->rangeEnd(), 0.1);
  EXPECT_TRUE(scale->isExceeded());
  range->setValue(0.0);
  window->model().change([](mien::FaceState& state) { state.fapValues.clear(); });
  settle();
  EXPECT_EQ(range->text(), "auto 2 mm") << "a face at rest begins anew";
  EXPECT_GE(scale->mapTo(window.get(), QPoint()).y(),
            view->mapTo(window.get(), QPoint(0, view->height() - view->foot())).y())
      << "below the face, not on it";
}

/// What is beside a number stays where it is when the number grows.
TEST_F(StudioWindow, NumbersThatGrowMoveNothing) {
  for (const char* dock : {"spectrumDock", "smoothingDock", "continuityDock", "deformationDock", "vectorsDock"})
    find<QAction>(QString(dock) + "Action")->trigger();
  const auto places = [this] {
    settle();
    std::map<QString, QRect> all;
    for (const QWidget* widget : window->findChildren<QWidget*>())
      if (!widget->objectName().isEmpty() && !widget->objectName().startsWith("qt_") && widget->isVisible())
        all[widget->objectName()] = QRect(widget->mapTo(window.get(), QPoint()), widget->size());
    return all;
  };
  const auto change = [this](double fap, double a) {
    window->model().change([&](mien::FaceState& state) {
      for (int number : {31, 32, 33, 34, 35, 36}) state.fapValues[number] = fap;
      state.surface.smoothing.fill(a);
      state.expressions["joy"] = fap > 0.0 ? 1.0 : 0.0;
    });
    for (int i = 0; i < 4; ++i) {
      settle();
      QTest::qWait(200);
    }
  };
  for (const char* dock : {"spectrumDock", "deformationDock", "vectorsDock"}) {
    find<QDockWidget>(dock)->raise();
    change(0.0, 1.0);
    const auto before = places();
    change(500.0, 2.125);
    const auto after = places();
    for (const auto& [name, place] : before) {
      const auto same = after.find(name);
      if (same == after.end() || name.endsWith("Numbers") || name.endsWith("Expression")) continue;  // texts
      EXPECT_EQ(same->second.left(), place.left()) << dock << " " << name.toStdString();
      EXPECT_EQ(same->second.width(), place.width()) << dock << " " << name.toStdString();
    }
  }
}

TEST_F(StudioWindow, TurnsOfTheHeadAreNoMovementOfTheCurvesUnlessAskedFor) {
  auto* view = find<CurveView>("curveView");
  window->model().change([](mien::FaceState& state) { state.expressions["joy"] = 1.0; });
  settle();
  const double joy = view->most();
  window->model().change([](mien::FaceState& state) { state.fapValues[49] = 20000.0; });
  settle();
  EXPECT_GT(largestDisplacement(), 2.0 * joy) << "mm, of a head turned by 0.2 rad";
  EXPECT_NEAR(view->most(), joy, 1e-4);
  find<QToolButton>("curveHead")->click();
  EXPECT_EQ(view->most(), largestDisplacement());
  find<QToolButton>("curveHead")->click();
  EXPECT_NEAR(view->most(), joy, 1e-4);
}

TEST_F(StudioWindow, TheCopiedCommandIsToldAndWhatItLeavesOut) {
  find<QAction>("actionCopyCommand")->trigger();
  EXPECT_EQ(message(), "The mien render command of this face was copied.");
  EXPECT_TRUE(QApplication::clipboard()->text().startsWith("mien render "));
  find<QComboBox>("colorBy")->setCurrentText("Patches");
  find<QToolButton>("faceCurves")->click();
  find<QToolButton>("faceCurveNames")->click();
  find<mien::ViewArea>("viewArea")->comparison()->pin();
  settle();
  find<QAction>("actionCopyCommand")->trigger();
  EXPECT_TRUE(message().contains("It leaves out: the comparison with B")) << message().toStdString();
  EXPECT_TRUE(message().contains("the names of the curves")) << message().toStdString();
  EXPECT_TRUE(QApplication::clipboard()->text().contains(" --curves "))
      << "what there is an option for is not left out";
}

void drop(mien::StudioWindow& window, const QString& file) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(file)});
  QDragEnterEvent enter(QPoint(600, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&window, &enter);
  QDropEvent event(QPointF(600, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&window, &event);
}

TEST_F(StudioWindow, ADroppedFileIsTakenForWhatItHolds) {
  QTemporaryDir folder;
  const auto write = [&](const char* name, const QByteArray& text) {
    QFile file(folder.filePath(name));
    file.open(QIODevice::WriteOnly);
    file.write(text);
    return file.fileName();
  };
  QByteArray table = "region,a1,a2,a3,a4,a5,a6,b1,b2,b3,b4,b5,b6\n";
  for (int region = 1; region <= 16; ++region) table += QByteArray::number(region) + ",0,0,0,1,0,0,0,0,0,0,1,0.02\n";
  const QString bent = write("bent.csv", table);
  drop(*window, bent);
  EXPECT_EQ(window->model().state().deformation.table, bent.toStdString());
  EXPECT_TRUE(message().startsWith("bent.csv bends the face")) << message().toStdString();
  drop(*window, write("points.csv", "landmark,vertex,x,y,z\n0,1225,-73,36,36\n"));
  EXPECT_TRUE(message().contains("once a scan is opened")) << message().toStdString();
  drop(*window, write("markers.csv", "marker,neutral_x,neutral_y,expression_x,expression_y\npupil_left,1,2,3,4\n"));
  EXPECT_TRUE(message().contains("mien fdt fit")) << message().toStdString();
  drop(*window, write("figure.pdf", "%PDF-1.4\n"));
  EXPECT_TRUE(message().contains("nothing that Mien Studio opens")) << message().toStdString();
  EXPECT_EQ(window->model().frameCount(), 0);
  drop(*window, write("faps.csv", "FAP19,FAP20\n0,0\n100,0\n"));
  EXPECT_EQ(window->model().frameCount(), 2);
  EXPECT_EQ(window->model().state().deformation.table, bent.toStdString());
}

TEST_F(StudioWindow, AnAnimationTableOfOnesOwnMovesTheFaceAndIsReadAnew) {
  QTemporaryDir folder;
  const QString name = folder.filePath("own.json");
  QFile builtIn(QString(MIEN_TEST_DIR) + "/../data/animation/animation_table.json");
  ASSERT_TRUE(builtIn.open(QIODevice::ReadOnly));
  const QJsonObject whole = QJsonDocument::fromJson(builtIn.readAll()).object();
  const auto write = [&](int without) {
    QJsonObject table = whole;
    QJsonArray faps;
    for (const QJsonValue& entry : whole["faps"].toArray())
      if (entry.toObject()["fap"].toInt() != without) faps.append(entry);
    table["faps"] = faps;
    QFile file(name);
    file.open(QIODevice::WriteOnly);
    file.write(QJsonDocument(table).toJson());
  };
  write(14);
  auto* back = find<QAction>("actionBuiltInTable");
  EXPECT_FALSE(back->isEnabled());
  EXPECT_TRUE(window->model().moves(14));
  drop(*window, name);
  EXPECT_EQ(window->model().state().animationTable, name.toStdString()) << message().toStdString();
  EXPECT_FALSE(window->model().moves(14));
  EXPECT_TRUE(message().startsWith("own.json says now")) << message().toStdString();
  write(0);
  ASSERT_TRUE(window->openAnimationTable(name));
  EXPECT_TRUE(window->model().moves(14)) << "read anew";
  QFile(name).open(QIODevice::WriteOnly);
  EXPECT_FALSE(window->openAnimationTable(name));
  EXPECT_TRUE(window->model().moves(14));
  EXPECT_TRUE(back->isEnabled());
  back->trigger();
  EXPECT_EQ(window->model().state().animationTable, "");
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
