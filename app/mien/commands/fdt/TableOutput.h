#pragma once

#include <string>

#include "DeformationTable.h"
#include "ReportOptions.h"

namespace CLI {
class App;
}

namespace mien {

/// Where a command leaves a table or a list (-o) and what it found (stdout, --json).
class TableOutput {
 public:
  void addTo(CLI::App& command, const std::string& help, bool required = false);

  /// Before anything is computed: throws a Failure for a file that cannot be written.
  void check() const;

  /// Does nothing without -o. `comment` stands at the head of the file.
  void write(const DeformationTable& table, const std::string& comment) const;
  void writeRows(const nlohmann::ordered_json& rows) const;

  /// The report as JSON or for reading.
  void print(const Report& report) const;

 private:
  std::string file_;
  bool json_ = false;
};

}  // namespace mien
