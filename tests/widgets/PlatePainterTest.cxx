#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>

#include "FigureApplication.h"
#include "FigureFile.h"
#include "OverlaidPanel.h"
#include "PicturePanel.h"
#include "PlaneAxes.h"
#include "PlaneDrawingPainter.h"
#include "PlatePainter.h"
#include "TemporaryFolder.h"
#include "TextFile.h"
#include "TextLines.h"
#include "TextTable.h"

namespace {

using mien::PlaneDrawing;
using mien::Plate;

/// A drawing of the unit square, 10 by 5 in the plane.
PlaneDrawing rectangle() {
  PlaneDrawing drawing;
  drawing.lines.push_back({QPolygonF({{0, 0}, {10, 0}, {10, 5}, {0, 5}}), {}, true});
  drawing.labels.push_back({{5, 5}, "C22'"});
  return drawing;
}

class PlatePainter : public testing::Test {
 protected:
  mien::FigureApplication application_;

  static mien::PlatePainter painter(const Plate& plate, double width = 85.0) {
    return mien::PlatePainter(plate, *mien::FigureTheme::find("light"), width);
  }

  static std::string svg(const Plate& plate) {
    const TemporaryFolder folder;
    const mien::PlatePainter drawn = painter(plate);
    EXPECT_EQ(mien::FigureFile(folder.file("plate.svg")).write(drawn.size(), [&](QPainter& p) { drawn.paint(p); }), "");
    return readTextFile(folder.file("plate.svg"));
  }
};

TEST_F(PlatePainter, PanelsFillTheirColumnsAndKeepTheirShape) {
  Plate plate;
  plate.columns = 2;
  plate.panels = {drawingPanel("one", rectangle()), drawingPanel("two", rectangle()), drawingPanel("", rectangle())};
  plate.panels[2].span = 2;
  const mien::PlatePainter drawn = painter(plate);
  const std::vector<QRectF>& places = drawn.places();
  for (size_t i = 0; i < places.size(); ++i)
    EXPECT_NEAR(places[i].height() / places[i].width(), plate.panels[i].shape, 1e-9);
  EXPECT_EQ(places[0].top(), places[1].top());
  EXPECT_GT(places[2].top(), places[0].bottom());
  EXPECT_NEAR(places[2].right(), places[1].right(), 1e-9);
  EXPECT_NEAR(places[0].width(), 100.0 * mien::PlatePainter::panelWidth(85.0, 2, 1), 1e-9);
  EXPECT_LT(places[2].bottom(), drawn.size().height());
  EXPECT_EQ(drawn.size().width(), 8500.0);
}

TEST_F(PlatePainter, DrawingsAreVectorsWithTextAndPicturesAreTheOnlyDots) {
  Plate plate;
  plate.panels = {drawingPanel("lips", rectangle())};
  plate.caption = "What is seen.";
  const std::string vectors = svg(plate);
  EXPECT_EQ(vectors.find("<image"), std::string::npos);
  EXPECT_NE(vectors.find("C22'"), std::string::npos);
  EXPECT_NE(vectors.find("What is seen."), std::string::npos);
  EXPECT_EQ(svg(plate), vectors);
  QImage picture(8, 4, QImage::Format_RGB32);
  picture.fill(Qt::red);
  plate.panels.push_back(mien::picturePanel("", picture));
  EXPECT_NE(svg(plate).find("<image"), std::string::npos);
}

TEST_F(PlatePainter, ADrawingHasOneScaleAndPointsUp) {
  const PlaneDrawing drawing = rectangle();
  const mien::PlaneDrawingPainter painter(drawing, QRectF(0, 0, 1000, 1000));
  const QPointF origin = painter.position({0, 0}), right = painter.position({10, 0}), up = painter.position({0, 5});
  EXPECT_NEAR(right.x() - origin.x(), 10.0 * painter.scale(), 1e-9);
  EXPECT_NEAR(origin.y() - up.y(), 5.0 * painter.scale(), 1e-9);
  EXPECT_NEAR(0.5 * (origin.x() + right.x()), 500.0, 1e-9);
  EXPECT_GT(origin.x(), 0.0);
  EXPECT_LT(right.x(), 1000.0);
}

TEST_F(PlatePainter, ANarrowTableIsHigher) {
  mien::TextTable table;
  table.columns = {{"Expression"}, {"Definition", 3.0}, {"Value", 1.0, true}};
  table.rows = {{"joy", "The brows rest; the mouth opens and its corners travel up and back", "250"}};
  const mien::PlatePanel wide = mien::tablePanel("", table, 170.0), narrow = mien::tablePanel("", table, 60.0);
  EXPECT_GT(narrow.shape * 60.0, 1.5 * wide.shape * 170.0);
  const std::string text = svg({"", {wide}, 1, "", ""});
  for (const char* word : {"Expression", "joy", "250"}) EXPECT_NE(text.find(word), std::string::npos) << word;
}

TEST_F(PlatePainter, AColumnIsAsWideAsItsLongestWord) {
  mien::TextTable table;
  table.columns = {{"Region", 3.0}, {"a1", 1.0, true}, {"b1", 1.0, true}};
  table.rows = {{"1", "a1\u00a0=\u00a0-0.1017", "b1\u00a0=\u00a0-0.1378"}};
  const mien::PlatePanel panel = mien::tablePanel("", table, 40.0);
  const std::string text = svg({"", {panel}, 1, "", ""});
  const auto left = [&](const std::string& word) {  // of the text that holds the word
    const size_t end = text.rfind("x=\"", text.find(word)) + 3;
    return std::stod(text.substr(end));
  };
  const QFont font = mien::figureFont(table.size);
  const double width = mien::textWidth(font, QString::fromUtf8("a1\u00a0=\u00a0-0.1017"));
  EXPECT_LT(left(">a1\u00a0=") + width, left(">b1\u00a0="));
}

TEST_F(PlatePainter, AxesSpanTheirRangeWithNumbersInsideThePanel) {
  PlaneDrawing drawing = rectangle();
  const QRectF range = drawing.bounds();
  const QRectF shown = mien::addPlaneAxes(drawing, range, 5.0, "mm", 60.0);
  EXPECT_TRUE(shown.contains(range));
  int numbers = 0;
  const mien::PlaneDrawingPainter painter(drawing, QRectF(0, 0, 6000, 6000), shown);
  for (const PlaneDrawing::Label& label : drawing.labels) {
    const double value = label.text.toDouble();
    if (label.alignment == int(Qt::AlignHCenter | Qt::AlignTop)) {
      EXPECT_NEAR(value, label.at.x(), 1e-9);
      ++numbers;
    } else if (label.alignment == int(Qt::AlignRight | Qt::AlignVCenter)) {
      EXPECT_NEAR(value, label.at.y(), 1e-9);
      EXPECT_GT(painter.position(label.at).x(), mien::textWidth(mien::figureFont(label.size), label.text));
      ++numbers;
    }
  }
  EXPECT_EQ(numbers, 5);  // 0, 5, 10 and 0, 5
}

TEST_F(PlatePainter, AStrokeWithoutWidthIsNotDrawn) {
  PlaneDrawing drawing;
  drawing.lines.push_back({QPolygonF({{0, 0}, {10, 0}, {10, 5}}), {QColor("#123456"), 0.0}, true});
  EXPECT_EQ(svg({"", {drawingPanel("", drawing)}, 1, "", ""}).find("#123456"), std::string::npos);
}

}  // namespace

TEST(OverlaidPanel, TheDrawingLiesOnItsPicture) {
  QImage picture(200, 120, QImage::Format_RGB888);
  picture.fill(Qt::white);
  mien::PlaneDrawing drawing;
  drawing.marks.push_back({{20.0, 100.0}, 2.0, {Qt::red, 0.1, false, Qt::red}});  // 20 from the left, 20 from the top
  const mien::PlatePanel panel = mien::overlaidPanel("", picture, drawing);
  QImage drawn(2000, 1200, QImage::Format_RGB888);
  drawn.fill(Qt::white);
  QPainter painter(&drawn);
  panel.paint(painter, QRectF(0, 0, 2000, 1200), *mien::FigureTheme::find("light"));
  painter.end();
  double x = 0.0, y = 0.0, count = 0.0;
  for (int row = 0; row < 1200; ++row)
    for (int column = 0; column < 2000; ++column)
      if (drawn.pixelColor(column, row).green() < 100) x += column + 0.5, y += row + 0.5, ++count;
  ASSERT_GT(count, 0.0);
  EXPECT_NEAR(x / count, 200.0, 1.0);
  EXPECT_NEAR(y / count, 200.0, 1.0);
}

TEST(FigureTheme, SeriesColoursOfTheLightThemeBecomeTheThemesOwn) {
  const mien::FigureTheme &light = *mien::FigureTheme::find("light"), &dark = *mien::FigureTheme::find("dark"),
                          &print = *mien::FigureTheme::find("print");
  for (std::size_t i = 0; i < light.series.size(); ++i) {
    EXPECT_EQ(light.own(light.series[i]), light.series[i]);
    EXPECT_EQ(dark.own(light.series[i]), dark.series[i]);
  }
  EXPECT_EQ(print.own(light.series[0]), light.series[0]) << "a colour that the theme has itself stays";
  EXPECT_EQ(dark.own(QColor(1, 2, 3)), QColor(1, 2, 3));
  EXPECT_FALSE(dark.own(QColor()).isValid());
}
