#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <QRegularExpression>
#include <cmath>
#include <cstdlib>

#include "ArrowShape.h"
#include "FigureApplication.h"
#include "FigureFile.h"
#include "FigureText.h"
#include "MotionVectorFigure.h"
#include "TemporaryFolder.h"
#include "TextFile.h"

namespace {

/// A sheet of 21 x 21 points, 5 mm apart, seen from the front, whose points move by a formula.
template <class Move>
mien::MotionVectorPanel sheet(const Move& move, const std::string& heading = {}) {
  constexpr int side = 21;
  mien::MotionField field;
  field.origins.resize(side * side, 3);
  field.vectors.resize(side * side, 3);
  field.columns = side;
  for (int i = 0; i < side * side; ++i) {
    field.origins.row(i) << 5.0 * (i % side), 5.0 * (i / side), 0.0;
    field.vectors.row(i) = move(field.origins.row(i));
    field.ids.push_back(i);
  }
  field.surface.vertices = field.origins;
  field.surface.triangles.resize(2 * (side - 1) * (side - 1), 3);
  for (int i = 0; i < (side - 1) * (side - 1); ++i) {
    const int a = i / (side - 1) * side + i % (side - 1);
    field.surface.triangles.row(2 * i) << a, a + 1, a + side;
    field.surface.triangles.row(2 * i + 1) << a + side, a + 1, a + side + 1;
  }
  field.normals = field.surfaceNormals = Eigen::RowVector3d(0, 0, 1).replicate(side * side, 1);
  field.seams.push_back(field.origins.middleRows(side * 10, side));
  return {field, heading};
}

Eigen::RowVector3d swirl(const Eigen::RowVector3d& p) {
  return {0.03 * (p.y() - 52.0), 0.02 * (52.0 - p.x()), 0.001 * p.x()};  // the middle is no point of the sheet
}

Eigen::RowVector3d still(const Eigen::RowVector3d&) {
  return {0.0, 0.0, 0.0};
}

std::string svgOf(const mien::MotionVectorFigure& figure, const std::string& ending = "svg") {
  const TemporaryFolder folder;
  const mien::FigureFile file(folder.file("a." + ending));
  const std::string fault = file.write(figure.size(), [&](QPainter& painter) { figure.paint(painter); });
  return fault.empty() ? mien::bytesOf(folder.file("a." + ending)) : fault;
}

/// Tails and tips of the arrows drawn in an SVG file, figure units.
std::vector<QLineF> arrowsIn(const std::string& svg) {
  std::vector<QLineF> arrows;
  const QRegularExpression path("<path[^>]* d=\"([^\"]*)\"");
  for (auto match = path.globalMatch(QString::fromStdString(svg)); match.hasNext();) {
    QPolygonF corners;
    const QRegularExpression place("[ML]([-0-9.e]+),([-0-9.e]+)");
    for (auto at = place.globalMatch(match.next().captured(1)); at.hasNext();) {
      const auto found = at.next();
      corners << QPointF(found.captured(1).toDouble(), found.captured(2).toDouble());
    }
    if (corners.size() >= 7 && corners.size() <= 8) arrows.emplace_back(0.5 * (corners[0] + corners[6]), corners[3]);
  }
  return arrows;
}

class MotionVectorFigure : public testing::Test {
 protected:
  mien::FigureApplication application_;
  mien::MotionVectorOptions options_;
};

TEST_F(MotionVectorFigure, DrawnLengthsOverTheScaleAreTheMagnitudes) {
  for (const double scale : {0.5, 1.0, 3.0}) {
    options_.scale = scale;
    options_.picture.plane.look({0.0, 0.0, 1.0}, {0.0, 1.0, 0.0});
    const mien::MotionVectorFigure figure({sheet(swirl)}, options_);
    const std::vector<QLineF> drawn = arrowsIn(svgOf(figure));
    const auto& arrows = figure.panels()[0].picture().arrows;
    ASSERT_EQ(drawn.size(), arrows.size() + 1);  // and the reference
    for (size_t i = 0; i < arrows.size(); ++i) {
      const double seen = arrows[i].vector.norm();
      EXPECT_NEAR(drawn[i].length() / 100.0 * scale, seen, 1e-3 * scale) << i;
      EXPECT_NEAR(drawn[i].dx() / 100.0 * scale, arrows[i].vector.x(), 1e-3 * scale);
      EXPECT_NEAR(drawn[i].dy() / 100.0 * scale, -arrows[i].vector.y(), 1e-3 * scale);
    }
    EXPECT_NEAR(drawn.back().length() / 100.0 * scale, figure.reference(), 1e-3 * scale);
  }
}

TEST_F(MotionVectorFigure, LengthsInSpaceAndEqualOnes) {
  options_.scale = 1.0;
  options_.length = mien::MotionVectorOptions::Length::InSpace;
  const mien::MotionVectorFigure inSpace({sheet(swirl)}, options_);
  const std::vector<QLineF> drawn = arrowsIn(svgOf(inSpace));
  const auto& arrows = inSpace.panels()[0].picture().arrows;
  for (size_t i = 0; i < arrows.size(); ++i) EXPECT_NEAR(drawn[i].length() / 100.0, arrows[i].magnitude, 1e-3);
  options_.length = mien::MotionVectorOptions::Length::Equal;
  for (const QLineF& arrow : arrowsIn(svgOf(mien::MotionVectorFigure({sheet(swirl)}, options_))))
    EXPECT_NEAR(arrow.length(), 250.0, 0.1);
}

TEST_F(MotionVectorFigure, ArrowsAsLargeAsTheFaceEndWherePointsGo) {
  options_.trueToFace = true;
  const mien::MotionVectorFigure figure({sheet(swirl)}, options_);
  const std::vector<QLineF> drawn = arrowsIn(svgOf(figure));
  const mien::VectorPanelPainter& panel = figure.panels()[0];
  for (size_t i = 0; i < panel.picture().arrows.size(); ++i) {
    const mien::PictureArrow& arrow = panel.picture().arrows[i];
    EXPECT_LT((panel.toFace(drawn[i].p2()) - arrow.tail - arrow.vector).norm(), 0.02);
  }
}

TEST_F(MotionVectorFigure, ZeroMotionHasNoArrowsAndSaysSo) {
  const mien::MotionVectorFigure figure({sheet(still)}, options_);
  const std::string svg = svgOf(figure);
  EXPECT_TRUE(arrowsIn(svg).empty());
  EXPECT_NE(svg.find("No motion"), std::string::npos);
  EXPECT_EQ(svg.find("mm of arrow"), std::string::npos);
}

TEST_F(MotionVectorFigure, HoldsVectorsAndTextAndNoRaster) {
  options_.title = "Motion vectors";
  const mien::MotionVectorFigure figure({sheet(swirl)}, options_);
  const std::string svg = svgOf(figure), pdf = svgOf(figure, "pdf");
  EXPECT_EQ(svg.find("<image"), std::string::npos);
  for (const char* const text : {"Motion vectors", "1 mm of arrow =", "Motion in space (mm)", "<polyline"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  EXPECT_EQ(pdf.find("/Subtype /Image"), std::string::npos);
  EXPECT_NE(pdf.find("/FontFile2"), std::string::npos);
}

TEST_F(MotionVectorFigure, TheSameFigureHasTheSameBytes) {
  setenv("SOURCE_DATE_EPOCH", "1700000000", 1);
  for (const char* const ending : {"svg", "pdf", "png"})
    EXPECT_TRUE(svgOf(mien::MotionVectorFigure({sheet(swirl)}, options_), ending) ==
                svgOf(mien::MotionVectorFigure({sheet(swirl)}, options_), ending))
        << ending;
  unsetenv("SOURCE_DATE_EPOCH");
}

TEST_F(MotionVectorFigure, ASeriesSharesScaleRangeAndSizeOfTheFace) {
  const auto weak = [](const Eigen::RowVector3d& p) -> Eigen::RowVector3d { return 0.2 * swirl(p); };
  const std::vector<mien::MotionVectorPanel> series = {sheet(weak, "frame 1"), sheet(swirl, "frame 2")};
  const mien::MotionVectorFigure together(series, options_), first(series, 0, options_), second(series, 1, options_);
  EXPECT_EQ(first.scale(), second.scale());
  EXPECT_EQ(first.rangeEnd(), second.rangeEnd());
  EXPECT_EQ(first.rangeEnd(), together.rangeEnd());
  EXPECT_EQ(first.panels()[0].plot(), second.panels()[0].plot());
  EXPECT_EQ(first.size(), second.size());
  EXPECT_EQ(together.panels()[0].plot().size(), together.panels()[1].plot().size());
  const std::string svg = svgOf(together);
  for (const char* const text : {"(a) frame 1", "(b) frame 2"}) EXPECT_NE(svg.find(text), std::string::npos);
  EXPECT_EQ(arrowsIn(svg).size(),
            together.panels()[0].picture().arrows.size() + together.panels()[1].picture().arrows.size() + 1);
  EXPECT_NEAR(arrowsIn(svgOf(first)).front().length() * 5.0, arrowsIn(svgOf(second)).front().length(), 1.0);
}

TEST_F(MotionVectorFigure, EverythingStaysInsideTheFigure) {
  options_.scale = 0.2;
  options_.picture.region.parse("80,80,100,100", nullptr);
  const mien::MotionVectorFigure figure({sheet([](const auto&) { return Eigen::RowVector3d(3.0, 2.0, 0.0); })},
                                        options_);
  for (const QLineF& arrow : arrowsIn(svgOf(figure)))
    EXPECT_TRUE(QRectF(QPointF(), figure.size()).contains(arrow.p2())) << arrow.p2().x() << " " << arrow.p2().y();
}

TEST_F(MotionVectorFigure, TheHeightCanBeGiven) {
  options_.height = 60.0;
  const mien::MotionVectorFigure figure({sheet(swirl)}, options_);
  EXPECT_NEAR(figure.size().height(), 6000.0, 1.0);
  EXPECT_LT(figure.panels()[0].plot().bottom(), 6000.0);
}

TEST_F(MotionVectorFigure, ValuesBeyondTheRangeHaveThePointedBar) {
  options_.range = {{0.5, 1.0}};
  const std::string with = svgOf(mien::MotionVectorFigure({sheet(swirl)}, options_));
  options_.range = {{0.0, 5.0}};
  const std::string without = svgOf(mien::MotionVectorFigure({sheet(swirl)}, options_));
  EXPECT_GT(QString::fromStdString(with).count("<path"), QString::fromStdString(without).count("<path"));
}

TEST_F(MotionVectorFigure, MotionTowardsTheViewerIsADot) {
  options_.scale = 1.0;
  const mien::MotionVectorFigure figure({sheet([](const auto&) { return Eigen::RowVector3d(0.0, 0.0, 4.0); })},
                                        options_);
  const std::string svg = svgOf(figure);
  EXPECT_EQ(QString::fromStdString(svg).count("<circle") + QString::fromStdString(svg).count("<ellipse"), 441);
  EXPECT_TRUE(arrowsIn(svg).empty());
}

TEST_F(MotionVectorFigure, SignedColoursAreSymmetricAboutZero) {
  options_.color = mien::MotionVectorOptions::Color::Towards;
  const mien::MotionVectorFigure away({sheet([](const auto&) { return Eigen::RowVector3d(1.0, 0.0, -2.7); })},
                                      options_);
  EXPECT_EQ(away.rangeBegin(), -3.0);
  EXPECT_EQ(away.rangeEnd(), 3.0);
  const mien::MotionVectorFigure across({sheet([](const auto&) { return Eigen::RowVector3d(5.0, 0.0, 1e-9); })},
                                        options_);
  EXPECT_EQ(across.rangeBegin(), -0.5) << "a tenth of the motion in space";
  EXPECT_EQ(across.rangeEnd(), 0.5);
  EXPECT_TRUE(across.lacksTowards());
  EXPECT_FALSE(away.lacksTowards());
  EXPECT_NE(svgOf(across).find("No motion towards the viewer"), std::string::npos);
  EXPECT_EQ(svgOf(away).find("No motion towards the viewer"), std::string::npos);
  for (const mien::FigureTheme& theme : mien::FigureTheme::all()) {
    const mien::VectorColors colors("coolwarm", theme, -2.0, 2.0);
    const QColor zero = colors.at(0.0);
    EXPECT_LT(zero.saturationF(), 0.03) << theme.name;
    EXPECT_GT(colors.at(-2.0).blue(), colors.at(-2.0).red() + 100);
    EXPECT_GT(colors.at(2.0).red(), colors.at(2.0).blue() + 100);
  }
}

TEST_F(MotionVectorFigure, EqualArrowsLeaveOutRipple) {
  options_.length = mien::MotionVectorOptions::Length::Equal;
  const auto ripple = [](const Eigen::RowVector3d& p) {
    return Eigen::RowVector3d(p.x() < 50.0 ? 8.0 : 0.01, 0.0, 0.0);
  };
  const mien::MotionVectorFigure figure({sheet(ripple)}, options_);
  EXPECT_EQ(figure.panels()[0].picture().arrows.size(), 210u);
  EXPECT_EQ(figure.panels()[0].picture().still, 231);
  EXPECT_NE(svgOf(figure).find("0.08 mm"), std::string::npos) << "the key says from where on";
  const mien::MotionVectorFigure towards({sheet([](const auto&) { return Eigen::RowVector3d(1e-6, 0.0, 4.0); })},
                                         options_);
  EXPECT_TRUE(arrowsIn(svgOf(towards)).empty()) << "a direction of rounding is none";
}

TEST_F(MotionVectorFigure, AutomaticSamplingIsOneForASeries) {
  options_.picture.sampling.parse("auto");
  options_.note = "Sheet";
  const std::vector<mien::MotionVectorPanel> series = {sheet(swirl), sheet(swirl), sheet(swirl)};
  const mien::MotionVectorFigure one({sheet(swirl)}, options_), three(series, options_);
  EXPECT_EQ(one.sampling().kind, mien::VectorSampling::Kind::Even);
  EXPECT_GT(three.sampling().spacing, one.sampling().spacing) << "smaller panels have fewer arrows";
  EXPECT_EQ(three.panels()[0].picture().chosen, three.panels()[2].picture().chosen);
  EXPECT_NE(svgOf(one).find("mm apart"), std::string::npos);
}

TEST(VectorColors, StandOutFromTheBackground) {
  for (const mien::FigureTheme& theme : mien::FigureTheme::all())
    for (const mien::ColorTable& table : mien::ColorTable::all())
      for (const std::string turn : {"", "_r"}) {
        const mien::VectorColors colors(table.name + turn, theme, 0.0, 1.0);
        for (double t = 0.0; t <= 1.0; t += 0.1)
          EXPECT_GT(std::abs(colors.at(t).lightnessF() - theme.background.lightnessF()), 0.1)
              << table.name << t << theme.name;
      }
  const mien::FigureTheme& light = mien::FigureTheme::all().front();
  EXPECT_EQ(mien::VectorColors("magma", light, 0.0, 1.0).at(0.0),
            mien::VectorColors("magma_r", light, 0.0, 1.0).at(1.0));
  EXPECT_FALSE(mien::VectorColors::isKnown("jet"));
}

TEST(ArrowShape, IsAsLongAsAskedHoweverShort) {
  for (const double length : {1.0, 30.0, 800.0}) {
    const QPolygonF shape = mien::arrowShape({10.0, 20.0}, {10.0 + 0.6 * length, 20.0 + 0.8 * length});
    ASSERT_EQ(shape.size(), 7);
    EXPECT_NEAR(QLineF(0.5 * (shape[0] + shape[6]), shape[3]).length(), length, 1e-9);
  }
  EXPECT_TRUE(mien::arrowShape({1.0, 1.0}, {1.0, 1.0}).isEmpty());
}

TEST_F(MotionVectorFigure, AKeyBesideThePanelLeavesTheHeightToTheFace) {
  mien::MotionVectorOptions options;
  options.width = 160.0;
  options.height = 90.0;
  const mien::MotionVectorFigure below({sheet(swirl)}, options);
  options.keyBeside = true;
  const mien::MotionVectorFigure beside({sheet(swirl)}, options);
  EXPECT_EQ(beside.size(), below.size());
  const QRectF plot = beside.panels()[0].plot(), key = beside.keyPlace();
  EXPECT_GT(plot.height(), 1.1 * below.panels()[0].plot().height());
  EXPECT_GT(plot.height(), 0.85 * 9000.0);
  EXPECT_LT(plot.right(), key.left());
  EXPECT_LT(key.left() - plot.right(), 1500.0) << "the key stands at the face, however wide the figure is";
  EXPECT_NEAR(plot.left(), 16000.0 - key.right(), 1000.0) << "both together stand in the middle";
  EXPECT_NE(svgOf(beside).find("Motion in space (mm)"), std::string::npos);
}

}  // namespace
