#include "ScanUnit.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>

#include "Arguments.h"
#include "Failure.h"
#include "LengthUnit.h"
#include "ScanAcquisition.h"

namespace mien {

void ScanUnit::addTo(CLI::App& command) {
  command.add_option("--units", units_, "What the scan's lengths are in: mm, cm, m or inch [recognised]");
  command.add_option("--scale", scale_, "Millimetres in one unit of the scan")->excludes("--units");
}

double ScanUnit::millimetres() const {
  if (!scale_.empty()) {
    const double scale = parseNumber("--scale", scale_);
    if (!(scale > 0.0))
      throw ValueFailure("--scale " + scale_ + " is not allowed; it is the number of mm in one unit, above 0");
    return scale;
  }
  if (units_.empty()) return 0.0;
  const LengthUnit* unit = lengthUnit(units_);
  if (!unit) throw ValueFailure("--units '" + units_ + "' is unknown; it is mm, cm, m or inch");
  return unit->millimetres;
}

void ScanUnit::remark(const std::string& scan, const ScanReport& report) {
  if (report.unitRecognised && report.unit != "mm")
    std::cerr << "mien: " << scan << ": lengths are taken as " << lengthUnit(report.unit)->fullName
              << ", which puts the outer eye corners " << std::lround(report.eyes)
              << " mm apart; --units says otherwise\n";
}

}  // namespace mien
