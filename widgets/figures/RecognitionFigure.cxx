#include "RecognitionFigure.h"

namespace mien {

Figure recognitionFigure(const std::vector<std::string>& names, const std::vector<RecognitionScore>& scores) {
  Figure figure;
  if (scores.empty()) return figure;
  Chart chart;
  chart.x.title = "Mean table";
  chart.x.categories = names;
  chart.y = {"Movement not explained", "pupil units"};
  chart.y.begin = 0.0;
  ChartSeries bars;
  bars.kind = ChartSeries::Kind::Bars;
  bars.y.resize(names.size());
  for (size_t i = 0; i < names.size(); ++i) bars.x.push_back(double(i));
  for (const RecognitionScore& score : scores) bars.y[score.expression] = score.distance;
  chart.series = {bars};
  figure.panels = {chart};
  figure.title = "Nearest expression: " + names[scores.front().expression];
  figure.caption =
      "RMS of the movement that the mean table of each expression does not explain, at the intensity (0.5 .. 1.5) that "
      "suits it "
      "best; without shift, rotation and scale of the whole face.";
  return figure;
}

}  // namespace mien
