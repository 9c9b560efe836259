#include <gtest/gtest.h>

#include <QPainter>
#include <QRegularExpression>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <set>

#include "FigureApplication.h"
#include "FigureText.h"
#include "SampleFigure.h"

namespace {

namespace fs = std::filesystem;

class FigurePainter : public testing::Test {
 protected:
  mien::FigureApplication application_;

  static mien::FigurePainter painter(const mien::Figure& figure, double width = 170.0) {
    return mien::FigurePainter(figure, *mien::FigureTheme::find("light"), width);
  }

  static QString svg(const mien::Figure& figure) {
    const std::string name =
        (fs::temp_directory_path() / ("mien_painter_" + std::to_string(getpid()) + ".svg")).string();
    const std::string text = mien::writtenFigure(figure, name);
    fs::remove(name);
    return QString::fromStdString(text);
  }

  /// The points of the n-th polyline with that many of them.
  static std::vector<QPointF> polyline(const QString& svg, int count) {
    auto matches = QRegularExpression("<polyline[^>]*points=\"([^\"]*)\"").globalMatch(svg);
    while (matches.hasNext()) {
      std::vector<QPointF> points;
      for (const QString& pair : matches.next().captured(1).split(' ', Qt::SkipEmptyParts))
        points.emplace_back(pair.section(',', 0, 0).toDouble(), pair.section(',', 1, 1).toDouble());
      if (static_cast<int>(points.size()) == count) return points;
    }
    return {};
  }
};

/// One line on linear axes 0 .. 10 and 0 .. 100.
mien::Figure oneLine() {
  mien::Chart chart;
  chart.x.endsWithData = true;
  chart.y.begin = 0.0;
  chart.y.end = 100.0;
  chart.series.push_back({"line", {0, 2, 5, 10}, {10.0, 30.0, 90.0, 50.0}});
  mien::Figure figure;
  figure.panels = {chart};
  return figure;
}

/// The tip of the triangle is where the line reaches the end of the axis.
TEST_F(FigurePainter, ALineThatRunsOutOfTheTopIsMarkedThere) {
  const auto isMarked = [](const mien::Figure& figure) {
    const mien::FigurePainter drawn = painter(figure);
    constexpr double pixel = 10.0;  // figure units
    QImage image(1700, static_cast<int>(drawn.size().height() / pixel), QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter canvas(&image);
    canvas.scale(1.0 / pixel, 1.0 / pixel);
    drawn.paint(canvas);
    const QPointF tip = drawn.panels()[0].position(4.1, 100.0);  // of 0 .. 10 and 0 .. 100
    const QPointF inside = tip + QPointF(mien::figureUnitsFromPoints(1.2), mien::figureUnitsFromPoints(3.2));
    return image.pixelColor((inside / pixel).toPoint()) == mien::FigureTheme::find("light")->series[0];
  };
  mien::Figure figure = oneLine();
  EXPECT_FALSE(isMarked(figure));
  EXPECT_FALSE(svg(figure).contains("off scale"));
  figure.panels[0].series[0].y[2] = 130.0;  // 100 at 2 + 0.7 * 3
  EXPECT_TRUE(isMarked(figure));
  EXPECT_TRUE(svg(figure).contains("off scale"));
}

TEST_F(FigurePainter, DrawnPointsAreTheData) {
  const mien::Figure figure = oneLine();
  const std::vector<QPointF> points = polyline(svg(figure), 4);
  ASSERT_EQ(points.size(), 4u);
  const QRectF plot = painter(figure).panels()[0].plot();
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(10.0 * (points[i].x() - plot.left()) / plot.width(), figure.panels[0].series[0].x[i], 1e-4);
    EXPECT_NEAR(100.0 * (plot.bottom() - points[i].y()) / plot.height(), figure.panels[0].series[0].y[i], 1e-3);
  }
}

TEST_F(FigurePainter, ValuesThatAreNotFiniteLeaveAGap) {
  mien::Figure figure = oneLine();
  figure.panels[0].series[0] = {
      "line", {0, 1, 2, 3, 4, 5, 10}, {1, 2, 3, std::numeric_limits<double>::quiet_NaN(), 4, 5, 6}};
  const QString text = svg(figure);
  EXPECT_EQ(polyline(text, 7).size(), 0u);
  EXPECT_EQ(polyline(text, 3).size(), 3u);
}

TEST_F(FigurePainter, LinesStayInsideTheirPlot) {
  mien::Figure figure = oneLine();
  figure.panels[0].series[0] = {"line", {0, 2, 5, 10}, {50.0, 60.0, 1e9, 50.0}};
  const QRectF plot = painter(figure).panels()[0].plot();
  const std::vector<QPointF> part = polyline(svg(figure), 3);
  ASSERT_EQ(part.size(), 3u);
  for (const QPointF& point : part) EXPECT_TRUE(plot.adjusted(-0.1, -0.1, 0.1, 0.1).contains(point));
}

TEST_F(FigurePainter, PanelsLieBesideEachOtherWithoutOverlap) {
  mien::Figure figure = mien::sampleFigure();
  for (int i = 0; i < 6; ++i) figure.panels.push_back(mien::sampleChart());
  for (const double width : {85.0, 170.0}) {
    const mien::FigurePainter layout = painter(figure, width);
    const QRectF page(QPointF(), layout.size());
    for (size_t i = 0; i < layout.panels().size(); ++i) {
      EXPECT_TRUE(page.contains(layout.panels()[i].plot()));
      EXPECT_GT(layout.panels()[i].plot().width(), 2000.0);  // 20 mm
      EXPECT_GT(layout.panels()[i].plot().height(), 1000.0);
      for (size_t j = 0; j < i; ++j) EXPECT_FALSE(layout.panels()[i].plot().intersects(layout.panels()[j].plot()));
    }
  }
}

TEST_F(FigurePainter, AGivenHeightIsKept) {
  const mien::FigurePainter layout(oneLine(), *mien::FigureTheme::find("dark"), 120.0, 60.0);
  EXPECT_EQ(layout.size(), QSizeF(12000.0, 6000.0));
}

TEST_F(FigurePainter, BarsReachFromZeroToTheirValue) {
  mien::Figure figure;
  figure.panels = {mien::sampleBars()};
  figure.panels[0].y.scale = mien::ChartAxis::Scale::Linear;
  const mien::FigurePainter layout = painter(figure);
  const mien::ChartPainter& panel = layout.panels()[0];
  const double height = panel.position(0.0, 0.0).y() - panel.position(0.0, 75.0).y();
  auto rectangles = QRegularExpression("<rect x=\"([^\"]*)\" y=\"([^\"]*)\" width=\"([^\"]*)\" height=\"([^\"]*)\"")
                        .globalMatch(svg(figure));
  bool found = false;
  while (rectangles.hasNext()) found = std::abs(rectangles.next().captured(4).toDouble() - height) < 0.1 || found;
  EXPECT_TRUE(found);
}

TEST_F(FigurePainter, NamesThatDoNotFitAreLeftOutNotDrawnOverEachOther) {
  mien::Figure figure = oneLine();
  mien::Chart& chart = figure.panels[0];
  for (int i = 0; i < 100; ++i) chart.x.categories.push_back(std::to_string(i));
  chart.x.categories.push_back("rest");
  auto texts = QRegularExpression("<text[^>]* x=\"([^\"]*)\"[^>]*>([^<]*)</text>").globalMatch(svg(figure));
  std::map<double, QString> names;
  while (texts.hasNext()) {
    const QRegularExpressionMatch match = texts.next();
    if (std::count(chart.x.categories.begin(), chart.x.categories.end(), match.captured(2).toStdString()))
      names[match.captured(1).toDouble()] = match.captured(2);
  }
  EXPECT_GE(names.size(), 5u);
  EXPECT_EQ(names.rbegin()->second, "rest");
}

TEST_F(FigurePainter, SeriesDifferInMoreThanColour) {
  mien::Figure figure;
  figure.panels = {mien::sampleChart()};
  auto patterns = QRegularExpression("stroke-dasharray=\"([^\"]*)\"").globalMatch(svg(figure));
  std::set<QString> different;
  while (patterns.hasNext()) different.insert(patterns.next().captured(1));
  EXPECT_GE(different.size(), 5u);
}

}  // namespace
