#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "SweepFigure.h"

namespace {

mien::SweepRecord record(const std::string& scheme, double a, double value) {
  mien::SweepRecord result;
  result.scheme = scheme;
  result.smoothing = a;
  result.values.assign(mien::sweepMeasureNames().size(), value);
  return result;
}

const mien::Chart* panel(const mien::Figure& figure, const std::string& title) {
  for (const mien::Chart& chart : figure.panels)
    if (chart.y.title == title) return &chart;
  return nullptr;
}

TEST(SweepFigure, AxesEndNearTheLastSurfaceThatIsAFace) {
  const mien::Figure figure = mien::sweepFigure(
      {record("four-curve", 1.0, 2.0), record("four-curve", 2.0, 3.0), record("four-curve", 10.0, 1e20)},
      {{"four-curve", 2.0}}, 1.0);
  const mien::Chart* chart = panel(figure, "Lebesgue constant");
  ASSERT_NE(chart, nullptr);
  EXPECT_LE(*chart->y.end, 1001.0);
  EXPECT_EQ(chart->series[0].y.back(), 1e20);  // the data themselves are complete
  EXPECT_EQ(*chart->series[0].breakdown, 2.0);
}

/// Where no scheme's surface is a face any more there is nothing to see: the plot does not keep half of itself for it.
TEST(SweepFigure, TheAxisOfAEndsSoonAfterTheLastBreakdown) {
  std::vector<mien::SweepRecord> records;
  for (double a = 0.125; a <= 128.0; a *= 2.0)
    for (const char* scheme : {"four-curve", "spline"}) records.push_back(record(scheme, a, a < 4.0 ? 100.0 + a : 1e9));
  const mien::Figure both = mien::sweepFigure(records, {{"four-curve", 2.0}, {"spline", 4.0}}, 1.0);
  const mien::Chart* area = panel(both, "Area");
  EXPECT_EQ(area->x.end, 8.0);
  EXPECT_LE(*area->y.end, 110.0) << "what a broken surface has does not stretch the axis";
  EXPECT_GE(*area->y.begin, 90.0);
  EXPECT_EQ(area->series[0].x.back(), 128.0);  // the data themselves are complete
  EXPECT_NE(both.caption.find("end at 8, twice the last of these: beyond, no scheme's surface is a face."),
            std::string::npos)
      << both.caption;
  EXPECT_NE(both.caption.find("Triangles"), std::string::npos) << "curves leave the panels";
  EXPECT_EQ(mien::sweepAxisTitle(*area), "a (beyond 8 no scheme's surface is a face: off scale)");
  const mien::Figure oneHolds = mien::sweepFigure(records, {{"four-curve", 2.0}}, 1.0);
  EXPECT_FALSE(panel(oneHolds, "Area")->x.end);
  EXPECT_EQ(oneHolds.caption.find("twice the last"), std::string::npos);
  EXPECT_EQ(mien::sweepAxisTitle(*panel(oneHolds, "Area")), "a");
  records.erase(std::remove_if(records.begin(), records.end(), [](const auto& one) { return one.scheme == "spline"; }),
                records.end());
  const mien::Figure alone = mien::sweepFigure(records, {{"four-curve", 3.1623}}, 1.0);
  EXPECT_EQ(mien::sweepAxisTitle(*panel(alone, "Area")), "a (beyond 6.3 the surface is no face: off scale)");
}

TEST(SweepFigure, ValuesThatAreAllZeroLieOnTheAxis) {
  const mien::Figure figure = mien::sweepFigure({record("spline", 1.0, 0.0), record("spline", 2.0, 0.0)}, {}, 1.0);
  EXPECT_EQ(panel(figure, "Seam angle")->y.begin, 0.0);
  EXPECT_EQ(panel(figure, "Folded cells")->y.begin, 0.0);
}

TEST(SweepFigure, ValuesOfAAreDrawnInTheirOrder) {
  const mien::Figure figure = mien::sweepFigure({record("spline", 5.0, 1.0), record("spline", 1.0, 2.0)}, {}, 1.0);
  EXPECT_EQ(figure.panels[0].series[0].x, (std::vector<double>{1.0, 5.0}));
}

TEST(SweepFigure, AMeasureWithoutValuesHasNoPanel) {
  mien::SweepRecord sample = record("spline", 1.0, 2.0);
  sample.values[mien::sweepMeasure("distance_rms_mm")] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(panel(mien::sweepFigure({sample}, {}, 1.0), "RMS to reference"), nullptr);
  EXPECT_NE(panel(mien::sweepFigure({sample}, {}, 1.0), "Area"), nullptr);
}

TEST(SweepFigure, ASchemeLooksTheSameWhateverIsBesideIt) {
  const int alone = mien::sweepFigure({record("spline", 1.0, 2.0)}, {}, 1.0).panels[0].series[0].style;
  const mien::Figure both = mien::sweepFigure({record("tangent", 1.0, 2.0), record("spline", 1.0, 2.0)}, {}, 1.0);
  EXPECT_EQ(both.panels[0].series[1].style, alone);
  EXPECT_NE(both.panels[0].series[0].style, alone);
}

}  // namespace
