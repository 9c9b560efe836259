#include "BoundFace.h"
#include "CatalogueFigures.h"
#include "ChartPanel.h"
#include "CsvText.h"
#include "CurveDrawing.h"
#include "FAPTable.h"
#include "FaceLayout.h"
#include "FigureContext.h"
#include "PlaneDrawingPainter.h"

namespace mien {

namespace {

constexpr int innerBrow = 31, middleBrow = 33, outerBrow = 35;
constexpr double raisedValue = 250.0;  // FAP units
constexpr int sumStyle = 4;
constexpr const char* curveName = "C6";
constexpr double from = 170.0 / 180.0 * M_PI, to = 262.0 / 180.0 * M_PI;  // the left brow along v

/// Weights of the three FAPs along v and their sum, at samples and between them.
Chart weightChart(const FaceAnimator& face) {
  Chart chart;
  chart.x = {"v", "degrees"};
  chart.y = {"Weight", ""};
  chart.y.begin = -0.1;  // between samples the curve ripples below 0
  chart.y.end = 1.1;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(face.neutral().curves.pointsPerCurve);
  const auto addSeries = [&](const std::string& name, const Eigen::VectorXd& weights, int style) {
    ChartSeries series;
    series.name = name;
    series.style = style;
    for (double v = from; v <= to + 1e-9; v += M_PI / 360.0) {
      series.x.push_back(v * 180.0 / M_PI);
      series.y.push_back(cardinalWeights(static_cast<int>(weights.size()), v).dot(weights));
    }
    chart.series.push_back(series);
  };
  constexpr int faps[] = {innerBrow, middleBrow, outerBrow};
  const auto weightsOf = [&](int fap) { return face.basis().weights(fap, FaceLayout::curveIndex(curveName)); };
  for (const int fap : faps) sum += weightsOf(fap);
  addSeries("Sum of the three", sum, sumStyle);  // first, under the others
  for (const int fap : faps)
    addSeries("FAP " + std::to_string(fap), weightsOf(fap), static_cast<int>(chart.series.size()) - 1);
  return chart;
}

/// The brow at rest and moved, with its samples and the way of each.
PlaneDrawing browDrawing(FaceAnimator& face, const std::vector<int>& faps) {
  const int curve = FaceLayout::curveIndex(curveName);
  FAPFrame frame;
  for (int fap : faps) frame.setValue(fap, raisedValue);
  const ClosedCurves moved = face.animate(frame);
  const CurveDrawing rest(face.neutral().curves, from, to), raised(moved, from, to);
  PlaneDrawing drawing;
  PlaneStroke dashed, bold;
  dashed.dashed = true;
  dashed.width = 0.5;
  bold.width = 1.1;
  bold.color = QColor("#0072b2");
  drawing.lines.push_back({rest.line(curve), dashed});
  drawing.lines.push_back({raised.line(curve), bold});
  const QPolygonF starts = rest.samples(curve), ends = raised.samples(curve);
  for (int i = 0; i < starts.size(); ++i) {
    if (QLineF(starts[i], ends[i]).length() > 0.5)
      drawing.lines.push_back({segment(starts[i], ends[i]), PlaneStroke(), false, true});
    drawing.marks.push_back({starts[i], 1.0, PlaneStroke()});
  }
  return drawing;
}

}  // namespace

FigureDrawing drawEyebrow(FigureContext& context) {
  FaceAnimator face = boundFace(context);
  const std::vector<std::pair<std::string, std::vector<int>>> cases = {
      {"FAP 31 (inner)", {innerBrow}},
      {"FAP 33 (middle)", {middleBrow}},
      {"FAP 35 (outer)", {outerBrow}},
      {"FAP 31, 33, 35 together", {innerBrow, middleBrow, outerBrow}}};
  std::vector<PlaneDrawing> drawings;
  QRectF shown;
  for (const auto& one : cases) {
    drawings.push_back(browDrawing(face, one.second));
    shown = shown.united(drawings.back().bounds());
  }
  Plate plate;
  plate.columns = 2;
  for (size_t i = 0; i < cases.size(); ++i) plate.panels.push_back(drawingPanel(cases[i].first, drawings[i], shown));
  plate.panels.push_back(chartPanel(weightChart(face), context.isNarrow() ? 0.5 : 0.27));
  plate.panels.back().span = 2;
  plate.panels.back().heading = "Weights along " + std::string(curveName);
  const double unit = face.units().perValue(fapDefinition(middleBrow).unit);
  plate.caption = "Values of " + shortestText(raisedValue) + " FAP units, " +
                  shortestText(std::round(raisedValue * unit * 100.0) / 100.0) +
                  " mm at weight 1; dashed: the neutral brow. The weights are staggered sinusoids that sum to at most "
                  "1 at the samples, so that no point rises further than the largest of the three; between samples "
                  "their interpolant ripples.";
  return context.drawn(plate);
}

}  // namespace mien
