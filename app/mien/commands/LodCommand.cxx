#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>

#include "Arguments.h"
#include "BoundaryCurveData.h"
#include "Command.h"
#include "CsvText.h"
#include "CurveModes.h"
#include "DetailFigure.h"
#include "FaceOptions.h"
#include "Failure.h"
#include "PipelineErrors.h"
#include "ReportOptions.h"
#include "ScanAcquisition.h"
#include "ScanUnit.h"
#include "TableRows.h"
#include "WatchedUpdate.h"
#include "vtkBoundaryCurveAcquisitionFilter.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkLevelOfDetailFilter.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkScanReader.h"
#include "vtkTable.h"
#include "vtkZLibDataCompressor.h"

namespace mien {

namespace {

using json = nlohmann::ordered_json;

struct LodCommandOptions {
  std::string scan, landmarks, tolerances = "0.05,0.1,0.2,0.5,1,2,4", points = "40", spacing = "2";
  ScanUnit unit;
  FaceOptions face;
  ReportOptions report;
};

constexpr long long gzipFrame = 12;  // bytes that gzip's header and trailer are longer than zlib's

/// The scan, and its curves: from --face, which must be in the frame of the scan, or measured as by mien acquire.
class MeasuredScan {
 public:
  explicit MeasuredScan(const LodCommandOptions& options) {
    for (vtkAlgorithm* algorithm : std::initializer_list<vtkAlgorithm*>{scan_, acquisition_, reader_})
      errors_.observe(algorithm);
    scan_->SetFileName(options.scan.c_str());
    scan_->Update();
    requireNoError("");
    const std::string face = options.face.state().curvesFile;
    face.empty() ? acquire(options) : read(face);
    const std::string fault = readFaceCurves(curves_, this->face);
    if (!fault.empty()) throw FileFailure(face + ": " + fault);
  }

  vtkPolyData* scan() const { return measured_; }  ///< mm, in the frame of the curves
  vtkPolyData* curves() const { return curves_; }
  FaceCurves face;

 private:
  void acquire(const LodCommandOptions& options) {
    acquisition_->SetInputConnection(scan_->GetOutputPort());
    if (!options.landmarks.empty()) acquisition_->SetLandmarkFileName(options.landmarks.c_str());
    acquisition_->SetPointsPerCurve(parseWholeNumber("--points", options.points));
    acquisition_->SetScale(options.unit.millimetres());
    updateWatched(acquisition_, "acquisition");
    requireNoError((options.landmarks.empty() ? options.scan : options.landmarks) + ":");
    ScanUnit::remark(options.scan, acquisition_->GetAcquired().report);
    curves_ = acquisition_->GetOutput();
    measured_ = vtkPolyData::SafeDownCast(acquisition_->GetOutputDataObject(1));
  }

  void read(const std::string& name) {
    reader_->SetFileName(name.c_str());
    reader_->Update();
    requireNoError("");
    curves_ = reader_->GetOutput();
    measured_ = scan_->GetOutput();
  }

  /// @param start  of a message that names its file; any other is about the scan
  void requireNoError(const std::string& start) const {
    const std::string fault = errors_.first();
    if (fault.empty()) return;
    const bool named = fault.rfind(start, 0) == 0;
    throw FileFailure(named ? fault : scan_->GetFileName() + (": " + fault));
  }

  vtkNew<vtkScanReader> scan_;
  vtkNew<vtkBoundaryCurveAcquisitionFilter> acquisition_;
  vtkNew<vtkBoundaryCurveReader> reader_;
  vtkPolyData *curves_ = nullptr, *measured_ = nullptr;
  PipelineErrors errors_;
};

std::vector<double> parseTolerances(const std::string& text) {
  std::vector<double> tolerances;
  for (const std::string& part : splitText(text, ',')) tolerances.push_back(parseMillimetres("--tolerances", part));
  return tolerances;
}

json fileRow(const json& like, const std::string& representation, const std::string& detail, long long bytes) {
  json row = like;
  for (auto& [name, value] : row.items()) value = nullptr;
  row["representation"] = representation;
  row["detail"] = detail;
  row["bytes"] = bytes;
  return row;
}

long long zippedSize(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(stream), {});
  vtkNew<vtkZLibDataCompressor> compressor;
  compressor->SetCompressionLevel(9);
  std::vector<unsigned char> zipped(compressor->GetMaximumCompressionSpace(bytes.size()));
  return gzipFrame + static_cast<long long>(compressor->Compress(reinterpret_cast<const unsigned char*>(bytes.data()),
                                                                 bytes.size(), zipped.data(), zipped.size()));
}

/// The scan as a file goes before the levels; of the scan itself there is no distance.
json rowsOf(const LodCommandOptions& options, vtkTable* table) {
  json rows = json::array(), levels = tableRows(table);
  const std::string name = std::filesystem::path(options.scan).filename().string();
  rows.push_back(
      fileRow(levels[0], "scan file", name, static_cast<long long>(std::filesystem::file_size(options.scan))));
  rows.push_back(fileRow(levels[0], "scan file, gzip", name, zippedSize(options.scan)));
  for (json level : levels) {
    for (auto& [column, value] : level.items())
      if (level["representation"] == "scan" && value.is_number_float()) value = nullptr;
    if (level["triangles"] == 0) level["triangles"] = nullptr;
    rows.push_back(level);
  }
  return rows;
}

double numberOf(const json& value) {
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

std::vector<DetailPoint> pointsOf(const json& rows) {
  std::vector<DetailPoint> points;
  for (const json& row : rows)
    if (row["representation"] != "PDE face")  // the last of the modes is the same
      points.push_back({row["representation"], numberOf(row["bytes"]), numberOf(row["symmetric_rms_mm"]),
                        numberOf(row["hausdorff_mm"])});
  return points;
}

std::string noteOf(const LodCommandOptions& options, const FaceSurfaceOptions& surface, int pointsPerCurve) {
  std::string a;
  for (const double value : surface.smoothing) a += (a.empty() ? "" : ", ") + shortestText(value);
  const bool uniform = std::all_of(surface.smoothing.begin(), surface.smoothing.end(),
                                   [&](double value) { return value == surface.smoothing[0]; });
  return std::filesystem::path(options.scan).filename().string() + "; K = " + std::to_string(pointsPerCurve) +
         "; scheme " + surface.scheme + "; a = " + (uniform ? shortestText(surface.smoothing[0]) : a) +
         "; N = " + std::to_string(surface.modes) + (surface.remainder ? " with remainder" : " without remainder") +
         "; points with z > 50 mm; Mien " MIEN_VERSION;
}

Report reportOf(const LodCommandOptions& options, vtkTable* table, int pointsPerCurve) {
  Report report;
  report.rows = rowsOf(options, table);
  report.readable = json::array();
  for (json row : report.rows) {
    for (const char* const less : {"max_mm", "back_max_mm", "symmetric_rms_mm"}) row.erase(less);
    report.readable.push_back(row);
  }
  report.json = {{"scan", options.scan}, {"points_per_curve", pointsPerCurve}, {"levels", report.rows}};
  report.remarks = {
      "Distances at points with z > 50 mm, 4 mm inside the first and last curve: rms from the level to the scan, back "
      "from the scan's "
      "outer skin to the level.",
      "Bytes: curves as single precision numbers; meshes as three of them per vertex and three 16 bit indices per "
      "triangle (32 bit beyond 65,536 "
      "vertices);",
      "compact faces as .mienz files; packed meshes rounded to about their error, predicted along the surface and "
      "entropy-coded alike. Meshes are "
      "the part that the face covers."};
  const double curveBytes = static_cast<double>(modeNumberCount(pointsPerCurve, pointsPerCurve / 2) * sizeof(float));
  const std::string note = noteOf(options, options.face.state().surface, pointsPerCurve);
  report.figure = [points = pointsOf(report.rows), curveBytes, note] {
    Figure figure = detailFigure(points, curveBytes);
    figure.note = note;
    return figure;
  };
  return report;
}

void run(const LodCommandOptions& options) {
  options.report.check();
  const FaceState state = options.face.state();
  if (!state.curvesFile.empty() && options.unit.millimetres() > 0.0)
    throw ValueFailure("--units and --scale are for scans that are measured; with --face the scan is in mm");
  const std::vector<double> tolerances = parseTolerances(options.tolerances);
  const double spacing = parseMillimetres("--spacing", options.spacing);
  if (!(spacing >= 0.1 && spacing <= 20.0))
    throw ValueFailure("--spacing '" + options.spacing + "' is not allowed; give 0.1mm to 20mm");
  const MeasuredScan measured(options);
  const int k = measured.face.curves.pointsPerCurve;
  const std::string fault = describeFault(state.surface, k);
  if (!fault.empty()) throw ValueFailure(fault);
  vtkNew<vtkLevelOfDetailFilter> filter;
  PipelineErrors errors;
  errors.observe(filter);
  filter->SetInputData(measured.curves());
  filter->SetScanData(measured.scan());
  filter->SetParameters(state.surface);
  filter->SetTolerances(tolerances);
  filter->SetSampleSpacing(spacing);
  updateWatched(filter, "comparison");
  if (!errors.first().empty()) throw FileFailure(options.scan + ": " + errors.first());
  options.report.deliver(reportOf(options, filter->GetOutput(), k));
}

}  // namespace

void addLodCommand(CLI::App& program) {
  const auto options = std::make_shared<LodCommandOptions>();
  CLI::App* command = program.add_subcommand("lod", "Compare levels of detail of a scanned head: bytes against error");
  command->add_option("scan", options->scan, "Scan of a head: .ply .obj .stl .off; in mm with --face")->required();
  command->add_option("--landmarks", options->landmarks,
                      "68 landmarks of the scan, FILE.csv as for mien acquire [fitted]");
  options->unit.addTo(*command);
  command->add_option("--points", options->points, "K, points per curve that are measured, even")
      ->capture_default_str();
  command->add_option("--tolerances", options->tolerances, "RMS errors of the compact faces, mm")
      ->capture_default_str();
  command->add_option("--spacing", options->spacing, "Of the points at which distances are measured, mm")
      ->capture_default_str();
  options->report.addTo(*command);
  options->face.addSurfaceOptions(*command);
  for (const char* const unused : {"--resolution", "--uniform-rows", "--precision"})
    command->remove_option(command->get_option(unused));
  command->footer(
      "Example: mien lod anna.ply --landmarks anna68.csv -o anna.csv -o anna.svg\n"
      "         mien lod anna.ply --face anna.vtp --json\n"
      "         mien lod anna.ply --units m --spacing 4 -o quick.csv\n"
      "The PDE face, its first N modes, compact faces (.mienz) and the decimated scan, each with its distance to the "
      "scan. Ctrl-C stops "
      "without output.");
  command->callback([options] { run(*options); });
}

}  // namespace mien
