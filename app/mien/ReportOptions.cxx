#include "ReportOptions.h"

#include <CLI/CLI.hpp>
#include <QPainter>
#include <algorithm>
#include <iostream>

#include "Arguments.h"
#include "Failure.h"
#include "FigureApplication.h"
#include "FigureFile.h"
#include "FigurePainter.h"
#include "OutputFile.h"
#include "TableRows.h"

namespace mien {

namespace {

constexpr double leastWidth = 40.0, mostWidth = 1000.0;  // mm

std::string list(const std::vector<std::string>& endings) {
  std::string text;
  for (const std::string& ending : endings) text += " ." + ending;
  return text;
}

std::string themeNames() {
  std::string names;
  for (const FigureTheme& theme : FigureTheme::all()) names += (names.empty() ? "" : ", ") + theme.name;
  return names;
}

bool isFigure(const std::string& name) {
  const std::vector<std::string>& endings = FigureFile::endings();
  return std::find(endings.begin(), endings.end(), fileEnding(name)) != endings.end();
}

void requireRange(const std::string& option, double value, double least, double most) {
  if (value >= least && value <= most) return;
  const auto text = [](double number) { return std::to_string(static_cast<int>(number)); };
  throw ValueFailure(option + " is outside " + text(least) + " .. " + text(most));
}

}  // namespace

void ReportOptions::addTo(CLI::App& command) {
  command.add_flag("--json", json_, "Machine-readable results on stdout");
  command.add_option("-o,--output", outputs_,
                     "Files to write, once for each: the table as .csv, the chart as .svg .pdf .png" +
                         (otherEndings_.empty() ? std::string() : ";" + list(otherEndings_)));
  command.add_option("--width", width_, "Of the chart, mm: 85 for one column, 170 for two")
      ->capture_default_str()
      ->group("Chart");
  command.add_option("--theme", theme_, "Of the chart: " + themeNames())->capture_default_str()->group("Chart");
  command.add_option("--dpi", dotsPerInch_, "Dots per inch of .png charts")->capture_default_str()->group("Chart");
}

double ReportOptions::width() const {
  return parseNumber("--width", width_);
}

double ReportOptions::dotsPerInch() const {
  return parseNumber("--dpi", dotsPerInch_);
}

void ReportOptions::check() const {
  std::vector<std::string> known = {"csv"};
  known.insert(known.end(), FigureFile::endings().begin(), FigureFile::endings().end());
  known.insert(known.end(), otherEndings_.begin(), otherEndings_.end());
  for (const std::string& name : outputs_) requireEnding(name, known);
  for (const std::string& name : outputs_)
    const OutputFile writable(name);  // known before a long computation, not after
  if (!FigureTheme::find(theme_))
    throw ValueFailure("--theme '" + theme_ + "' is unknown; the known ones are " + themeNames());
  requireRange("--width", width(), leastWidth, mostWidth);
  requireRange("--dpi", dotsPerInch(), FigureFile::leastDotsPerInch, FigureFile::mostDotsPerInch);
}

std::vector<std::string> ReportOptions::outputs(const std::string& ending) const {
  std::vector<std::string> names;
  for (const std::string& name : outputs_)
    if (fileEnding(name) == ending) names.push_back(name);
  return names;
}

void ReportOptions::writeFigure(const Figure& figure, const std::string& name, const std::string& command) const {
  const FigureApplication application;
  const FigurePainter painter(figure, *FigureTheme::find(theme_), width());
  FigureFile file(name);
  file.setDotsPerInch(dotsPerInch());
  file.setTitle(figure.title);
  file.setDescription(command + "\n" + figure.note);
  const std::string fault = file.write(painter.size(), [&](QPainter& p) { painter.paint(p); });
  if (!fault.empty()) throw FileFailure(fault);
}

void ReportOptions::deliver(const Report& report, const std::string& command) const {
  for (const std::string& name : outputs_) {
    if (fileEnding(name) == "csv") OutputFile::write(name, csvText(report.rows));
    if (isFigure(name)) writeFigure(report.figure(), name, command);
  }
  if (json_) {
    std::cout << report.json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << "\n";
    return;
  }
  std::cout << readableText(report.readable.is_null() ? report.rows : report.readable);
  for (const std::string& remark : report.remarks) std::cout << remark << "\n";
}

}  // namespace mien
