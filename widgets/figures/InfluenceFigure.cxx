#include "InfluenceFigure.h"

#include "SchemeStyle.h"

namespace mien {

namespace {

constexpr double curvesPerPatch = 3.0;

}  // namespace

Figure influenceFigure(const std::vector<InfluenceProfile>& profiles, double moved, const std::string& movement) {
  Chart chart;
  chart.x = ChartAxis{"Curve, 1 at the top of the face", ""};
  chart.x.begin = 1.0;
  chart.x.end = 28.0;
  chart.x.step = curvesPerPatch;
  chart.y = ChartAxis{"Largest move of the surface", "mm per mm"};
  for (const InfluenceProfile& profile : profiles)
    chart.series.push_back(
        {profile.scheme, profile.curve, profile.influence, ChartSeries::Kind::Line, schemeStyle(profile.scheme)});
  chart.marks.push_back({moved, false, movement});
  Figure figure;
  figure.panels = {chart};
  figure.title = "Influence of one curve";
  figure.caption = "How far the surface moves, at each height of the face, when a curve moves by 1 mm.";
  return figure;
}

}  // namespace mien
