#include "FigureTheme.h"

#include <QtMath>
#include <algorithm>

namespace mien {

namespace {

QString& fontFamily() {
  static QString family;
  return family;
}

}  // namespace

const std::vector<FigureTheme>& FigureTheme::all() {
  static const std::vector<FigureTheme> themes = {{"light",
                                                   "#ffffff",
                                                   "#222222",
                                                   "#444444",
                                                   "#e3e3e3",
                                                   {"#0072b2", "#3c9bd0", "#009e73", "#b0548a", "#c98500", "#d55e00"},
                                                   1.1,
                                                   0.5},
                                                  {"dark",
                                                   "#1d2126",
                                                   "#e6e6e6",
                                                   "#b0b5ba",
                                                   "#3a4047",
                                                   {"#59aee8", "#a9d8f5", "#3cc79c", "#e39ac4", "#f0b93a", "#f28a3c"},
                                                   1.1,
                                                   0.5},
                                                  {"print",
                                                   "#ffffff",
                                                   "#000000",
                                                   "#000000",
                                                   "#dddddd",
                                                   {"#000000", "#0072b2", "#00875f", "#a8447f", "#a06a00", "#d55e00"},
                                                   0.9,
                                                   0.4}};
  return themes;
}

QColor FigureTheme::own(const QColor& color) const {
  if (!color.isValid() || std::find(series.begin(), series.end(), color) != series.end()) return color;
  const std::vector<QColor>& light = find("light")->series;
  const auto found = std::find(light.begin(), light.end(), color);
  const std::size_t index = found - light.begin();
  return index < series.size() ? series[index] : color;
}

const FigureTheme* FigureTheme::find(const std::string& name) {
  for (const FigureTheme& theme : all())
    if (theme.name == name) return &theme;
  return nullptr;
}

void setFigureFontFamily(const QString& family) {
  fontFamily() = family;
}

QFont figureFont(double points, bool bold) {
  QFont font(fontFamily().isEmpty() ? QStringLiteral("DejaVu Sans") : fontFamily());
  font.setStyleHint(QFont::SansSerif);
  font.setHintingPreference(QFont::PreferNoHinting);
  font.setPixelSize(qRound(figureUnitsFromPoints(points)));
  font.setBold(bold);
  return font;
}

}  // namespace mien
