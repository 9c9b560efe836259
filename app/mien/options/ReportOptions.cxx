#include "ReportOptions.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "CommandText.h"
#include "Failure.h"
#include "FigureApplication.h"
#include "FigureFile.h"
#include "FigurePainter.h"
#include "OutputFile.h"
#include "PlatePainter.h"
#include "TableRows.h"

namespace mien {

namespace {

std::string list(const std::vector<std::string>& endings) {
  std::string text;
  for (const std::string& ending : endings) text += " ." + ending;
  return text;
}

}  // namespace

void ReportOptions::addTo(CLI::App& command) {
  command_ = &command;
  command.add_flag("--json", json_, "Machine-readable results on stdout");
  command.add_option("-o,--output", outputs_,
                     "Files to write, once for each: the table as .csv, the chart as .svg .pdf .png" +
                         (otherEndings_.empty() ? std::string() : ";" + list(otherEndings_)));
  drawing_.addTo(command, "Chart");
}

void ReportOptions::check() const {
  std::vector<std::string> known = {"csv"};
  known.insert(known.end(), FigureFile::endings().begin(), FigureFile::endings().end());
  known.insert(known.end(), otherEndings_.begin(), otherEndings_.end());
  for (const std::string& name : outputs_) requireEnding(name, known);
  for (const std::string& name : outputs_)
    const OutputFile writable(name);  // known before a long computation, not after
  drawing_.check();
}

std::vector<std::string> ReportOptions::outputs(const std::string& ending) const {
  std::vector<std::string> names;
  for (const std::string& name : outputs_)
    if (fileEnding(name) == ending) names.push_back(name);
  return names;
}

void ReportOptions::writeFigure(const Report& report, const std::string& name, const std::string& state) const {
  const FigureApplication application;
  const std::string command = commandText(*command_, {"--output", "--json"}) + "\n",
                    made = state.empty() ? state : "\n" + state;
  const FigureTheme& theme = *FigureTheme::find(drawing_.theme());
  if (report.plate) {
    const Plate plate = report.plate(drawing_.width());
    const PlatePainter painter(plate, theme, drawing_.width());
    drawing_.write(
        name, painter.size(), [&](QPainter& p) { painter.paint(p); }, plate.title, command + plate.note + made);
    return;
  }
  const Figure figure = report.figure();
  const FigurePainter painter(figure, theme, drawing_.width());
  drawing_.write(
      name, painter.size(), [&](QPainter& p) { painter.paint(p); }, figure.title, command + figure.note + made);
}

void ReportOptions::deliver(const Report& report, const std::string& state) const {
  for (const std::string& name : outputs_) {
    if (fileEnding(name) == "csv") OutputFile::write(name, csvText(report.rows));
    if (FigureOptions::isFigure(name)) writeFigure(report, name, state);
  }
  if (json_) {
    std::cout << report.json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << "\n";
    return;
  }
  std::cout << readableText(report.readable.is_null() ? report.rows : report.readable);
  for (const std::string& remark : report.remarks) std::cout << remark << "\n";
}

}  // namespace mien
