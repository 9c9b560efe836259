#include <gtest/gtest.h>

#include "SpectrumFigure.h"

namespace {

const std::vector<mien::ModeMeasures> modes = {
    {"0", 3.0, 4.0, 0.9, 1.0}, {"1", 1.0, 2.0, 0.1, 0.2}, {"remainder", 0.2, 0.3, 0.0, 0.0}};

TEST(SpectrumFigure, OneSchemeIsDrawnAsBarsOfItsMeasures) {
  const mien::Figure figure = mien::spectrumFigure({{"spline", modes}}, 0.1);
  ASSERT_EQ(figure.panels.size(), 3u);
  EXPECT_EQ(figure.panels[0].series[0].kind, mien::ChartSeries::Kind::Bars);
  EXPECT_EQ(figure.panels[0].series[0].y, (std::vector<double>{3.0, 1.0, 0.2}));
  EXPECT_EQ(figure.panels[2].series[0].y, (std::vector<double>{1.0, 0.2}));  // with the remainder nothing is missing
  ASSERT_EQ(figure.panels[2].marks.size(), 1u);
  EXPECT_EQ(figure.panels[2].marks[0].value, 0.1);
}

/// The caption names the panel by the letter that it has, whatever is beside it.
TEST(SpectrumFigure, PartsAreLetteredInTheirOrder) {
  using Part = mien::SpectrumPart;
  EXPECT_NE(mien::spectrumFigure({{"spline", modes}}, {}).caption.find("(c) What the sum"), std::string::npos);
  const mien::Figure two = mien::spectrumFigure({{"spline", modes}}, {}, {Part::Energy, Part::Missing});
  ASSERT_EQ(two.panels.size(), 2u);
  EXPECT_EQ(two.panels[0].y.title, "Share of the energy");
  EXPECT_NE(two.caption.find("(b) What the sum"), std::string::npos);
  const mien::Figure one = mien::spectrumFigure({{"spline", modes}}, {}, {Part::Missing});
  EXPECT_EQ(one.caption.find('('), std::string::npos);
}

TEST(SpectrumFigure, SeveralSchemesDifferInMoreThanColour) {
  const mien::Figure figure = mien::spectrumFigure({{"four-curve", modes}, {"spline", modes}}, {});
  for (const mien::Chart& panel : figure.panels)
    for (const mien::ChartSeries& series : panel.series) EXPECT_EQ(series.kind, mien::ChartSeries::Kind::Samples);
  EXPECT_NE(figure.panels[0].series[0].style, figure.panels[0].series[1].style);
}

TEST(SpectrumFigure, NothingIsNoFigure) {
  EXPECT_TRUE(mien::spectrumFigure({}, {}).panels.empty());
}

}  // namespace
