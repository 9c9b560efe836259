#include "ScanInfo.h"

#include <filesystem>

#include "Failure.h"
#include "InfoText.h"
#include "Interruption.h"
#include "NumberText.h"
#include "OutputFile.h"
#include "ProgressLine.h"
#include "ScanSummary.h"

namespace mien {

namespace {

using json = nlohmann::ordered_json;

ScanSummary summaryOf(const std::string& file) {
  noteInterruptions();
  ScanSummary summary;
  ProgressLine line;
  const std::string fault = summarizeScan(file, summary, [&](double done) {
    line.showShare(done);
    return !wasInterrupted();
  });
  if (wasInterrupted()) throw Stopped("stopped before the scan's unit was found");
  if (!fault.empty()) throw FileFailure(fault);
  return summary;
}

json boxOf(const ScanSummary& scan, double scale) {
  json box = json::object();
  const char* const axes[] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) box[axes[i]] = {scale * scan.low[i], scale * scan.high[i]};
  return box;
}

std::string extentText(const json& box) {
  std::string text;
  for (const auto& axis : box.items())
    text += (text.empty() ? "" : ", ") + axis.key() + " " + roundedText(axis.value()[0]) + " .. " +
            roundedText(axis.value()[1]);
  return text;
}

std::string polygonText(const json& polygons) {
  std::string text;
  for (const auto& kind : polygons.items())
    if (kind.value() != 0) text += (text.empty() ? "" : ", ") + kind.value().dump() + " " + kind.key();
  return text;
}

}  // namespace

json describeScanFile(const std::string& file) {
  const std::string ending = fileEnding(file);
  if (ending != "ply" && ending != "obj" && ending != "stl" && ending != "off") return nullptr;
  const ScanSummary scan = summaryOf(file);
  json about = {
      {"file", file},
      {"file_bytes", std::filesystem::file_size(file)},
      {"points", scan.points},
      {"polygons",
       {{"triangles", scan.polygons.triangles}, {"quads", scan.polygons.quads}, {"larger", scan.polygons.larger}}},
      {"triangles", scan.triangles},
      {"merged_vertices", scan.mergedVertices},
      {"degenerate_triangles", scan.degenerateTriangles},
      {"components", scan.components},
      {"largest_component_share", scan.largestShare},
      {"boundary_loops", scan.boundaryLoops},
      {"boundary_loops_of_largest", scan.loopsOfLargest},
      {"bounds", boxOf(scan, 1.0)},
      {"unit", scan.unit.empty() ? json(nullptr) : json(scan.unit)},
      {"possible_units", scan.possibleUnits}};
  if (scan.unit.empty()) about["unit_unknown"] = scan.unitFault;
  if (scan.millimetres > 0.0) about["bounds_mm"] = boxOf(scan, scan.millimetres);
  return about;
}

void printScanFile(const json& scan) {
  printLine("scan", scan["file"]);
  printLine("file", scan["file_bytes"].dump() + " bytes");
  printLine("points",
            scan["points"].dump() + ", of which " + scan["merged_vertices"].dump() + " lie where another lies");
  printLine("polygons", polygonText(scan["polygons"]) + "; " + scan["triangles"].dump() + " triangles once split, " +
                            scan["degenerate_triangles"].dump() + " of them without area or twice");
  printLine("components", scan["components"].dump() + ", the largest with " +
                              twoDigits(100.0 * scan["largest_component_share"].get<double>()) + " % of the area");
  printLine("boundary loops", scan["boundary_loops"].dump() + " (rims and holes), " +
                                  scan["boundary_loops_of_largest"].dump() + " of them in the largest component");
  printLine("bounds", extentText(scan["bounds"]) + " (as in the file)");
  if (scan["unit"].is_null()) return printLine("unit", "unknown: " + scan["unit_unknown"].get<std::string>());
  printLine("unit", scan["unit"].get<std::string>() + ", guessed from its size; mien acquire measures the scan so");
  printLine("bounds (mm)", extentText(scan["bounds_mm"]));
}

}  // namespace mien
