#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>

#include "Arguments.h"
#include "DefaultRegions.h"
#include "DeformedFace.h"
#include "FaceFrame.h"
#include "FaceOptions.h"
#include "FacePipeline.h"
#include "Failure.h"
#include "FdtCommands.h"
#include "OutputFile.h"
#include "PackedTable.h"
#include "ReportOptions.h"
#include "TableInput.h"
#include "TableRows.h"
#include "TableText.h"
#include "vtkStructuredGrid.h"

namespace mien {

namespace {

struct FdtPackCommandOptions {
  std::string table, outputFile, bits = "16";
  bool json = false;
};

int bitsOf(const FdtPackCommandOptions& options) {
  const int bits = parseWholeNumber("--bits", options.bits);
  if (bits != 8 && bits != 16) throw ValueFailure("--bits " + options.bits + " is not allowed; give 8 or 16");
  return bits;
}

/// How far the packed table takes points of the generic face beside where the table itself takes them.
struct FaceError {
  double largest = 0.0, unit = 1.0;  ///< mm

  FaceError(const DeformationTable& table, const DeformationTable& packed) {
    FacePipeline pipeline;
    FaceOptions().apply(pipeline);
    updateOrThrow(pipeline);
    const auto a = deformSurface(pipeline.grid(), table, {}, "generic face");
    const auto b = deformSurface(pipeline.grid(), packed, {}, "generic face");
    for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
      largest = std::max(largest, (Eigen::Vector3d(a->GetPoint(i)) - Eigen::Vector3d(b->GetPoint(i))).norm());
    FaceFrame frame;
    if (readPupils(pipeline.grid(), {}, frame).empty()) unit = frame.pupils.unit();
  }
};

void run(const FdtPackCommandOptions& options) {
  const int bits = bitsOf(options);
  requireEnding(options.outputFile, {"fdt"});
  const DeformationTable table = readTable(options.table);
  std::string fault = describePacking(table, bits);
  const std::string bytes = fault.empty() ? packTable(table, bits) : std::string();
  DeformationTable packed;
  if (fault.empty()) fault = unpackTable(bytes, packed);
  if (!fault.empty()) throw FileFailure(options.table + ": " + fault);
  const FaceError error(table, packed);
  DeformationTable plain = table;
  plain.deviations.reset();
  const double bound = packingError(table, bits, defaultRegions());
  OutputFile::write(options.outputFile, bytes);
  const nlohmann::ordered_json about = {{"table", options.table},
                                        {"bits", bits},
                                        {"bytes", bytes.size()},
                                        {"text_bytes", writeTable(plain).size()},
                                        {"error_bound", bound},
                                        {"error_bound_mm", bound * error.unit},
                                        {"generic_face_error_mm", error.largest}};
  if (options.json)
    std::cout << about.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << "\n";
  else
    std::cout << bytes.size() << " bytes (" << about["text_bytes"] << " as text without deviations); error at most "
              << readableNumber(bound * error.unit) << " mm anywhere on a face, " << readableNumber(error.largest)
              << " mm on the generic face\n";
}

}  // namespace

void addFdtPackCommand(CLI::App& parent) {
  const auto options = std::make_shared<FdtPackCommandOptions>();
  CLI::App* command = parent.add_subcommand("pack", "Write a table in fixed point, a few hundred bytes");
  command->add_option("table", options->table, "Table")->required();
  command->add_option("--bits", options->bits, "Bits of each coefficient: 8 or 16")->capture_default_str();
  command->add_option("-o,--output", options->outputFile, "Packed table to write, FILE.fdt")->required();
  command->add_flag("--json", options->json, "Machine-readable results on stdout");
  command->footer(
      "Example: mien fdt pack joy --bits 8 -o joy.fdt && mien render --fdt joy.fdt -o joy.png\n"
      "Packed tables are read wherever a TABLE is; standard deviations are left out. mien fdt blend joy.fdt -o joy.csv "
      "unpacks.");
  command->callback([options] { run(*options); });
}

}  // namespace mien
