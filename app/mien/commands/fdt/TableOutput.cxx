#include "TableOutput.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "Failure.h"
#include "OutputFile.h"
#include "TableRows.h"
#include "TableText.h"

namespace mien {

void TableOutput::addTo(CLI::App& command, const std::string& help, bool required) {
  command.add_option("-o,--output", file_, help)->required(required);
  command.add_flag("--json", json_, "Machine-readable results on stdout");
}

void TableOutput::check() const {
  if (file_.empty()) return;
  requireEnding(file_, {"csv"});
  const OutputFile writable(file_);
}

void TableOutput::write(const DeformationTable& table, const std::string& comment) const {
  if (file_.empty()) return;
  const std::string excess = table.describeExcess();
  if (!excess.empty()) throw FileFailure(file_ + " is not written: " + excess);
  OutputFile::write(file_, writeTable(table, comment));
}

void TableOutput::writeRows(const nlohmann::ordered_json& rows) const {
  if (!file_.empty()) OutputFile::write(file_, csvText(rows));
}

void TableOutput::print(const Report& report) const {
  if (json_) {
    std::cout << report.json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << "\n";
    return;
  }
  std::cout << readableText(report.readable.is_null() ? report.rows : report.readable);
  for (const std::string& remark : report.remarks) std::cout << remark << "\n";
}

}  // namespace mien
