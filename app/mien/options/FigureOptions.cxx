#include "FigureOptions.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "Arguments.h"
#include "Failure.h"
#include "FigureFile.h"
#include "FigureFont.h"
#include "FigureTheme.h"
#include "OutputFile.h"

namespace mien {

namespace {

constexpr double leastWidth = 40.0, mostWidth = 1000.0;  // mm

std::string themeNames() {
  std::string names;
  for (const FigureTheme& theme : FigureTheme::all()) names += (names.empty() ? "" : ", ") + theme.name;
  return names;
}

}  // namespace

void requireRange(const std::string& option, double value, double least, double most, const std::string& unit) {
  if (value >= least && value <= most) return;
  const auto text = [](double number) { return std::to_string(static_cast<int>(number)); };
  throw ValueFailure(option + " is outside " + text(least) + " .. " + text(most) + (unit.empty() ? "" : " " + unit));
}

void FigureOptions::addTo(CLI::App& command, const std::string& group) {
  command.add_option("--width", width_, "Of the figure, mm (or with cm, in, pt): 85 for one column, 170 for two")
      ->capture_default_str()
      ->group(group);
  command.add_option("--theme", theme_, "Of the figure: " + themeNames())->capture_default_str()->group(group);
  command.add_option("--font", font_, "Family of the figure's type [DejaVu Sans]")->group(group);
  command.add_option("--dpi", dotsPerInch_, "Dots per inch of .png figures")->capture_default_str()->group(group);
}

double FigureOptions::width() const {
  return parseMillimetres("--width", width_);
}

double FigureOptions::dotsPerInch() const {
  return parseNumber("--dpi", dotsPerInch_);
}

void FigureOptions::check() const {
  if (!FigureTheme::find(theme_))
    throw ValueFailure("--theme '" + theme_ + "' is unknown; the known ones are " + themeNames());
  requireRange("--width", width(), leastWidth, mostWidth, "mm");
  requireRange("--dpi", dotsPerInch(), FigureFile::leastDotsPerInch, FigureFile::mostDotsPerInch);
  if (!font_.empty()) requireFont("--font", font_);
  setFigureFontFamily(QString::fromStdString(font_));
}

bool FigureOptions::isFigure(const std::string& name) {
  const std::vector<std::string>& endings = FigureFile::endings();
  return std::find(endings.begin(), endings.end(), fileEnding(name)) != endings.end();
}

void FigureOptions::write(const std::string& name, const QSizeF& size, const std::function<void(QPainter&)>& draw,
                          const std::string& title, const std::string& description) const {
  FigureFile file(name);
  file.setDotsPerInch(dotsPerInch());
  file.setTitle(title);
  file.setDescription(description);
  const std::string fault = file.write(size, draw);
  if (!fault.empty()) throw FileFailure(fault);
}

}  // namespace mien
