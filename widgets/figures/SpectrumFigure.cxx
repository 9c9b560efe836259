#include "SpectrumFigure.h"

#include <algorithm>
#include <limits>

#include "AxisScale.h"
#include "PanelLabel.h"
#include "SchemeStyle.h"

namespace mien {

namespace {

constexpr double leastShare =
    1e-9;  // of the largest value: what is smaller is rounding and would only stretch the axis

Chart chartOf(const std::vector<SchemeSpectrum>& spectra, const ChartAxis& y, double ModeMeasures::*measure,
              ChartSeries::Kind kind, bool ofModesOnly) {
  Chart chart;
  chart.x.title = "Mode n";
  chart.y = y;
  const size_t count =
      spectra.front().modes.size() - (ofModesOnly && spectra.front().modes.back().mode == "remainder" ? 1 : 0);
  for (size_t i = 0; i < count; ++i) {
    const ModeMeasures& mode = spectra.front().modes[i];
    chart.x.categories.push_back(mode.mode == "remainder" ? "rest" : mode.mode);
  }
  double largest = 0.0;
  for (const SchemeSpectrum& spectrum : spectra)
    for (const ModeMeasures& mode : spectrum.modes) largest = std::max(largest, mode.*measure);
  for (const SchemeSpectrum& spectrum : spectra) {
    ChartSeries series;
    if (spectra.size() > 1) series.name = spectrum.scheme;  // one alone is named in the note
    series.kind = kind;
    series.style = spectra.size() > 1 ? schemeStyle(spectrum.scheme) : 0;
    for (size_t i = 0; i < std::min(count, spectrum.modes.size()); ++i) {
      const double value = spectrum.modes[i].*measure;
      series.x.push_back(i);
      series.y.push_back(value > leastShare * largest ? value : std::numeric_limits<double>::quiet_NaN());
    }
    chart.series.push_back(series);
  }
  return chart;
}

Chart chartOf(const std::vector<SchemeSpectrum>& spectra, SpectrumPart part) {
  const auto axis = [](const char* title, const char* unit) {
    return ChartAxis{title, unit, ChartAxis::Scale::Automatic};
  };
  const auto samples = ChartSeries::Kind::Samples;
  const auto bars = spectra.size() > 1 ? samples : ChartSeries::Kind::Bars;  // many bars differ in colour alone
  switch (part) {
    case SpectrumPart::Length:
      return chartOf(spectra, axis("RMS of the contribution", "mm"), &ModeMeasures::rms, bars, false);
    case SpectrumPart::Energy:
      return chartOf(spectra, axis("Share of the energy", ""), &ModeMeasures::energyShare, bars, false);
    default:
      return chartOf(spectra, axis("RMS missing from the sum", "mm"), &ModeMeasures::cumulativeError, samples, true);
  }
}

}  // namespace

Figure spectrumFigure(const std::vector<SchemeSpectrum>& spectra, const std::optional<double>& tolerance,
                      const std::vector<SpectrumPart>& parts) {
  Figure figure;
  if (spectra.empty() || spectra.front().modes.empty()) return figure;
  figure.title = "Spectrum of the surface";
  figure.caption =
      "What each Fourier mode adds to the surface; \"rest\" is the remainder, all harmonics above N together.";
  for (const SpectrumPart part : parts) {
    figure.panels.push_back(chartOf(spectra, part));
    if (part != SpectrumPart::Missing) continue;
    const std::string label = panelLabel(figure.panels.size() - 1, parts.size()).toStdString();
    figure.caption += (label.empty() ? " " : " " + label + " ") + "What the sum of the modes up to n lacks.";
    if (tolerance)
      figure.panels.back().marks.push_back({*tolerance, true, "tolerance " + tickText(*tolerance, *tolerance) + " mm"});
  }
  return figure;
}

}  // namespace mien
