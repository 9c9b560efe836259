#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "Figure.h"
#include "FigureOptions.h"
#include "Plate.h"

namespace CLI {
class App;
}

namespace mien {

/// What a measuring command has found.
struct Report {
  nlohmann::ordered_json json;               ///< all of it, for --json
  nlohmann::ordered_json rows;               ///< the table, array of objects
  nlohmann::ordered_json readable;           ///< the table for reading where it differs from `rows`
  std::vector<std::string> remarks;          ///< sentences below the table
  std::function<Figure()> figure;            ///< drawn only when it is asked for
  std::function<Plate(double width)> plate;  ///< in its place, for a width in mm
};

/// The options of commands that measure: where the table and the chart go, and how the chart looks.
class ReportOptions {
 public:
  /// @param otherEndings  files the command writes itself, without the dot
  explicit ReportOptions(std::vector<std::string> otherEndings = {}) : otherEndings_(std::move(otherEndings)) {}

  void addTo(CLI::App& command);

  /// Before anything is computed: throws a ValueFailure for a wrong option or ending.
  void check() const;

  /// Of the files to write, those with that ending.
  std::vector<std::string> outputs(const std::string& ending) const;

  /// Writes the files, and the table or JSON on stdout. Charts keep the command as it was given.
  /// @param state  of the face, which charts keep as well; empty when there is none
  void deliver(const Report& report, const std::string& state = {}) const;

 private:
  void writeFigure(const Report& report, const std::string& name, const std::string& state) const;

  const CLI::App* command_ = nullptr;
  std::vector<std::string> otherEndings_, outputs_;
  FigureOptions drawing_{"170"};
  bool json_ = false;
};

}  // namespace mien
