#include <vtkPolyData.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QSettings>
#include <QTemporaryDir>

#include "Comparison.h"
#include "ExportDialog.h"
#include "Exporter.h"
#include "FaceModel.h"
#include "FaceView.h"
#include "StudioFixture.h"
#include "ViewArea.h"

namespace {

class ExportDialog : public StudioFixture {
 protected:
  mien::Exporter* face() { return find<mien::ViewArea>("viewArea")->faceExporter(); }
  mien::Exporter* curves() { return find<mien::ViewArea>("viewArea")->curveExporter(); }
  QString path(const char* name) const { return folder.filePath(name); }

  static QList<QByteArray> lines(const QString& name) {
    QFile file(name);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return file.readAll().trimmed().split('\n');
  }

  /// The share of a page that is drawn on.
  static double ink(const QImage& picture) {
    double sum = 0.0;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) sum += 255 - qGray(picture.pixel(x, y));
    return sum / (255.0 * picture.width() * picture.height());
  }

  QTemporaryDir folder;
};

TEST_F(ExportDialog, TheFaceHasTheSizeResolutionAndBackgroundAskedFor) {
  mien::ExportOptions options;
  options.width = 60.0;
  options.dotsPerInch = 254.0;  // ten pixels a millimetre
  for (const char* theme : {"light", "dark"})
    for (bool transparent : {false, true}) {
      options.theme = theme;
      options.transparent = transparent;
      ASSERT_TRUE(face()->write(path("face.png"), options)) << message().toStdString();
      const QImage picture(path("face.png"));
      EXPECT_EQ(picture.width(), 600);
      EXPECT_EQ(picture.dotsPerMeterX(), 10000);
      const QColor corner = picture.pixelColor(2, 2), middle = picture.pixelColor(300, picture.height() / 2);
      EXPECT_EQ(corner.alpha(), transparent ? 0 : 255) << theme;
      if (!transparent) {
        EXPECT_EQ(corner, options.figureTheme().background) << theme;
      }
      EXPECT_EQ(middle.alpha(), 255) << theme;
      EXPECT_GT(middle.lightness(), 60) << theme;
    }
}

/// The same face at another resolution is the same picture, with lines as wide in proportion.
TEST_F(ExportDialog, ResolutionChangesNothingButTheNumberOfPixels) {
  mien::ExportOptions options;
  options.width = 50.0;
  ASSERT_TRUE(curves()->write(path("curves.png"), options));  // the message about it takes room from the view
  settle();
  std::vector<QImage> pictures;
  for (double dots : {240.0, 480.0}) {
    options.dotsPerInch = dots;
    ASSERT_TRUE(curves()->write(path("curves.png"), options));
    pictures.emplace_back(path("curves.png"));
  }
  EXPECT_NEAR(pictures[1].width(), 2.0 * pictures[0].width(), 2);
  EXPECT_NEAR(ink(pictures[1]) / ink(pictures[0]), 1.0, 0.05) << "lines of the same pixels would have half of it";
}

TEST_F(ExportDialog, TheViewIsAsBeforeAfterwards) {
  drawViews();
  ASSERT_TRUE(face()->write(path("face.png"), {}));  // the message about it takes room from the view
  settle();
  auto* view = find<mien::FaceView>("faceView");
  const QImage before = view->grab().toImage();
  ASSERT_TRUE(face()->write(path("face.png"), {}));
  settle();
  const QImage after = view->grab().toImage();
  EXPECT_EQ(after, before);
}

TEST_F(ExportDialog, WhatColoursMeanStandsBelowTheFace) {
  mien::ExportOptions options;
  const auto below = [&] {  // the picture of the view
    const QSizeF size = face()->drawing(options).size;
    const auto* view = find<mien::FaceView>("faceView");
    return size.height() - size.width() * view->freeHeight() / view->width();
  };
  EXPECT_NEAR(below(), 0.0, 1e-6);
  find<QComboBox>("colorBy")->setCurrentText("Patches");
  settle();
  EXPECT_GT(below(), 4.0 * mien::figureUnitsPerMillimetre);
  ASSERT_TRUE(face()->write(path("face.svg"), options));
  const QByteArray text = lines(path("face.svg")).join('\n');
  EXPECT_TRUE(text.contains(">P8<")) << "as text, not as a picture of it";
}

/// A comparison is one figure, of A and of B, and says which is which.
TEST_F(ExportDialog, AComparisonHasBothFaces) {
  find<mien::ViewArea>("viewArea")->comparison()->pin();
  window->model().change([](mien::FaceState& state) { state.expressions["joy"] = 1.0; });
  settle();
  EXPECT_DOUBLE_EQ(face()->drawing({}).size.width(), 170.0 * mien::figureUnitsPerMillimetre);
  ASSERT_TRUE(face()->write(path("both.svg")));
  const QByteArray text = lines(path("both.svg")).join('\n');
  EXPECT_TRUE(text.contains(">A: joy<")) << "as text";
  EXPECT_TRUE(text.contains(">B: the neutral face<"));
  EXPECT_TRUE(text.contains(">Difference A\u2013B (mm)<"));
  EXPECT_EQ(text.count("<image"), 2);
  ASSERT_TRUE(face()->write(path("both.png")));
  const QImage both(path("both.png"));
  const int half = both.width() / 2;
  EXPECT_NE(both.copy(0, 0, half, both.height() / 2), both.copy(half, 0, half, both.height() / 2));
  ASSERT_TRUE(face()->write(path("both.csv")));
  EXPECT_TRUE(lines(path("both.csv"))[0].contains(",Distance,")) << lines(path("both.csv"))[0].toStdString();
}

TEST_F(ExportDialog, NumbersOfViewsAreTheirPoints) {
  window->model().change([](mien::FaceState& state) { state.expressions["joy"] = 1.0; });
  settle();
  ASSERT_TRUE(curves()->write(path("curves.csv")));
  const auto rows = lines(path("curves.csv"));
  EXPECT_TRUE(rows[0].startsWith("x,y,z,")) << rows[0].toStdString();
  EXPECT_TRUE(rows[0].contains("Displacement_x"));
  EXPECT_EQ(rows.size(), 1 + 29 * 40);
  ASSERT_TRUE(face()->write(path("face.csv")));
  EXPECT_EQ(lines(path("face.csv")).size(), 1 + surface()->GetNumberOfPoints());
}

TEST_F(ExportDialog, ShowsTheSizeAndDoesNotAskNumbersForColours) {
  mien::ExportDialog dialog(face(), window.get());
  dialog.findChild<QDoubleSpinBox*>("exportWidth")->setValue(100.0);
  dialog.findChild<QDoubleSpinBox*>("exportDots")->setValue(254.0);
  auto* size = dialog.findChild<QLabel*>("exportSize");
  EXPECT_TRUE(waitUntil([&] { return size->text().contains("1000 \u00d7"); })) << size->text().toStdString();
  EXPECT_TRUE(size->text().contains("100 \u00d7"));
  auto* format = dialog.findChild<QComboBox*>("exportFormat");
  format->setCurrentText("CSV");
  EXPECT_FALSE(dialog.findChild<QComboBox*>("exportTheme")->isEnabled());
  EXPECT_EQ(dialog.ending(), "csv");
  EXPECT_FALSE(dialog.save("/there/is/no/such/folder/face.csv"));
  EXPECT_TRUE(message().contains("face.csv"));
}

TEST_F(ExportDialog, RemembersEverythingButTheWidth) {
  QTemporaryDir settings;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  QCoreApplication::setOrganizationName("mien-test");
  double usual = 0.0;
  {
    mien::ExportDialog dialog(face(), window.get());
    usual = dialog.options().width;
    dialog.findChild<QDoubleSpinBox*>("exportWidth")->setValue(120.0);
    dialog.findChild<QDoubleSpinBox*>("exportDots")->setValue(600.0);
    dialog.findChild<QComboBox*>("exportTheme")->setCurrentText("print");
    dialog.findChild<QCheckBox*>("exportTransparent")->setChecked(true);
    dialog.findChild<QComboBox*>("exportFormat")->setCurrentText("PDF");
    EXPECT_TRUE(dialog.save(path("face.pdf")));
  }
  const mien::ExportOptions options = mien::ExportDialog(face(), window.get()).options();
  EXPECT_EQ(options.width, usual);
  EXPECT_EQ(options.dotsPerInch, 600.0);
  EXPECT_EQ(options.theme, "print");
  EXPECT_TRUE(options.transparent);
  EXPECT_EQ(mien::ExportDialog(face(), window.get()).ending(), "pdf");
  QCoreApplication::setOrganizationName(QString());
}

}  // namespace
