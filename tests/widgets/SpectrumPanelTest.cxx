#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QToolButton>

#include "ExportButton.h"
#include "FaceModel.h"
#include "FigureView.h"
#include "StudioFixture.h"

namespace {

class SpectrumPanel : public StudioFixture {
 protected:
  SpectrumPanel() {
    find<QAction>("spectrumDockAction")->trigger();
    figure = find<mien::FigureView>("spectrumFigure");
    EXPECT_TRUE(waitUntil([this] { return bars().size() == 7; }));
  }

  std::vector<double> bars() const {
    const auto& panels = figure->figure().panels;
    return panels.empty() ? std::vector<double>() : panels[0].series[0].y;
  }
  QImage face() {
    settle();
    return find<QWidget>("faceView")->grab().toImage();
  }

  mien::FigureView* figure;
};

TEST_F(SpectrumPanel, IsClosedUntilAskedFor) {
  EXPECT_TRUE(find<QDockWidget>("spectrumDock")->isVisible());
  mien::StudioWindow other;
  other.show();
  EXPECT_FALSE(other.findChild<QDockWidget*>("spectrumDock")->isVisible());
}

TEST_F(SpectrumPanel, AClickedBarShowsItsContributionAndOneButtonTheSkinAgain) {
  const QImage skin = face();
  QTest::mouseClick(figure, Qt::LeftButton, Qt::NoModifier, figure->pixelOf(0, 2, bars()[2]).toPoint() + QPoint(0, 3));
  EXPECT_EQ(find<QComboBox>("spectrumMode")->currentText(), "2");
  EXPECT_EQ(*figure->marked(), 2.0);
  EXPECT_TRUE(find<QToolButton>("spectrumOnFace")->isChecked());
  const QImage second = face();
  EXPECT_NE(second, skin);
  EXPECT_GT(colorsIn("faceView"), 500);
  QTest::mouseClick(find<QToolButton>("faceSkin"), Qt::LeftButton);
  EXPECT_FALSE(find<QToolButton>("spectrumOnFace")->isChecked());
  EXPECT_EQ(face(), skin);
}

TEST_F(SpectrumPanel, ArrowKeysChooseModesAndStopAtTheEnds) {
  QTest::keyClick(figure, Qt::Key_Right);
  EXPECT_EQ(find<QComboBox>("spectrumMode")->currentText(), "2");
  const QImage second = face();
  QTest::keyClick(figure, Qt::Key_End);
  EXPECT_EQ(find<QComboBox>("spectrumMode")->currentText(), "remainder");
  EXPECT_NE(face(), second);
  QTest::keyClick(figure, Qt::Key_Home);
  EXPECT_EQ(find<QComboBox>("spectrumMode")->currentText(), "0");
}

TEST_F(SpectrumPanel, FollowsTheFace) {
  const std::vector<double> before = bars();
  window->model().change([](mien::FaceState& state) { state.fapValues[53] = 400; });
  EXPECT_TRUE(waitUntil([&] { return bars() != before; }));
  window->model().change([](mien::FaceState& state) { state.surface.modes = 9; });
  EXPECT_TRUE(waitUntil([&] { return bars().size() == 11; }));
  EXPECT_EQ(find<QComboBox>("spectrumMode")->count(), 11);
}

TEST_F(SpectrumPanel, AModeThatIsGoneGivesWayToTheLast) {
  QTest::keyClick(figure, Qt::Key_End);
  window->model().change([](mien::FaceState& state) {
    state.surface.modes = 2;
    state.surface.remainder = false;
  });
  EXPECT_TRUE(waitUntil([&] { return bars().size() == 3; }));
  EXPECT_EQ(find<QComboBox>("spectrumMode")->currentText(), "2");
  EXPECT_EQ(message(), "");
}

TEST_F(SpectrumPanel, EnergiesSumToOne) {
  find<QComboBox>("spectrumMeasure")->setCurrentIndex(1);
  double sum = 0.0;
  for (double share : bars()) sum += std::isfinite(share) ? share : 0.0;
  EXPECT_NEAR(sum, 1.0, 1e-8);
}

TEST_F(SpectrumPanel, APartialSumChangesTheShape) {
  QTest::keyClick(figure, Qt::Key_Right);
  const QImage whole = face();
  find<QCheckBox>("spectrumPartial")->click();
  EXPECT_NE(face(), whole);
}

TEST_F(SpectrumPanel, ItsFigureSaysOfWhichFaceItIs) {
  const QString name = QDir::temp().filePath(QString("mien_face_%1.svg").arg(QCoreApplication::applicationPid()));
  window->model().change([](mien::FaceState& state) { state.expressions["joy"] = 0.5; });
  settle();
  ASSERT_TRUE(find<mien::ExportButton>("spectrumExport")->write(name));
  QFile file(name);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QByteArray text = file.readAll();
  EXPECT_TRUE(text.contains("Spectrum of the surface: joy at 0.5"));
  EXPECT_TRUE(text.contains("Generic face, scheme spline; a = 1; N = 5 with remainder; joy at 0.5"));
  EXPECT_TRUE(text.contains("(b)")) << "lettered as the dock is";
  EXPECT_FALSE(text.contains("(c)"));
  file.remove();
}

TEST_F(SpectrumPanel, WritesItsFigureAndNumbers) {
  auto* button = find<mien::ExportButton>("spectrumExport");
  const QString folder = QDir::temp().filePath(QString("mien_export_%1").arg(QCoreApplication::applicationPid()));
  ASSERT_TRUE(QDir().mkpath(folder));
  for (const char* ending : {"svg", "pdf", "png"}) {
    const QString name = folder + "/spectrum." + ending;
    EXPECT_TRUE(button->write(name)) << ending;
    EXPECT_GT(QFile(name).size(), 2000) << ending;
  }
  EXPECT_TRUE(button->write(folder + "/spectrum.csv"));
  QFile csv(folder + "/spectrum.csv");
  ASSERT_TRUE(csv.open(QIODevice::ReadOnly));
  const QList<QByteArray> lines = csv.readAll().trimmed().split('\n');
  EXPECT_EQ(lines.size(), 8);
  EXPECT_TRUE(lines.first().startsWith("mode,rms_mm,max_mm,energy_share,cumulative_rms_error_mm"));
  EXPECT_FALSE(button->write(folder + "/there_is_no_folder/spectrum.svg"));
  EXPECT_FALSE(message().isEmpty());
  QDir(folder).removeRecursively();
}

}  // namespace
