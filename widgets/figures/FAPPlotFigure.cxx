#include "FAPPlotFigure.h"

#include <algorithm>
#include <cmath>

#include "SeriesThinning.h"

namespace mien {

namespace {

constexpr int bins = 1000;  // four points each: finer than any screen or page

/// The frames that are seen, and one more at either end, for the lines that leave the plot.
std::pair<int, int> framesBetween(const FAPSequence& motion, double begin, double end) {
  const int last = static_cast<int>(motion.frames.size()) - 1;
  const double first = std::floor(begin * motion.framesPerSecond), after = std::ceil(end * motion.framesPerSecond);
  return {static_cast<int>(std::clamp(first, 0.0, double(last))),
          static_cast<int>(std::clamp(after, 0.0, double(last)))};
}

ChartSeries seriesOf(const FAPSequence& motion, const PlottedFAP& plotted, std::pair<int, int> frames) {
  std::vector<double> times, values;
  for (int i = frames.first; i <= frames.second; ++i) {
    times.push_back(motion.timeOfFrame(i));
    values.push_back(motion.frames[i].value(plotted.fap));
  }
  ChartSeries series;
  series.name = plotted.name;
  series.style = plotted.style;
  for (const auto& [time, value] : thinnedSeries(times, values, bins)) {
    series.x.push_back(time);
    series.y.push_back(value);
  }
  return series;
}

}  // namespace

Figure fapPlotFigure(const FAPSequence& motion, const std::vector<PlottedFAP>& faps, double begin, double end) {
  Figure figure;
  if (motion.frames.empty() || faps.empty()) return figure;
  Chart chart;
  chart.x.title = "Time";
  chart.x.unit = "s";
  chart.x.begin = begin;
  chart.x.end = end;
  chart.x.endsWithData = true;
  chart.y.title = "Value";
  chart.y.unit = "FAP units";
  for (const PlottedFAP& plotted : faps)
    chart.series.push_back(seriesOf(motion, plotted, framesBetween(motion, begin, end)));
  figure.title = "Facial animation parameters over time";
  figure.panels.push_back(chart);
  return figure;
}

}  // namespace mien
