#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "AnimationInfo.h"
#include "BoundaryCurveData.h"
#include "Command.h"
#include "CurveCrossings.h"
#include "FAPUnits.h"
#include "FaceLayout.h"
#include "FaceOptions.h"
#include "FacePipeline.h"
#include "Failure.h"
#include "FigureInfo.h"
#include "InfoText.h"
#include "JsonInfo.h"
#include "NumberText.h"
#include "OutputFile.h"
#include "PictureInfo.h"
#include "ProgressLine.h"
#include "Remarks.h"
#include "RowLayout.h"
#include "ScanInfo.h"
#include "TableInfo.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkDataArray.h"
#include "vtkFAPReader.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

namespace mien {

namespace {

using json = nlohmann::ordered_json;

struct InfoCommandOptions {
  FaceOptions face;
  std::string file;
  bool json = false;
};

constexpr int bytesPerCoordinate = 4;  // curves are kept and sent as single precision

FaceCurves knownNeutralFace(const FacePipeline& pipeline) {
  FaceCurves face;
  const std::string fault = readFaceCurves(pipeline.neutralCurves()->GetOutput(), face);
  if (!fault.empty()) throw FileFailure(fault);
  return face;
}

/// Only a face with its feature points has units; why it has none is said on stderr.
json describeUnits(const FaceCurves& face, const std::string& name) {
  FAPUnits units;
  const std::string fault = measureFAPUnits(face, units);
  if (!fault.empty()) {
    std::cerr << "mien: " << name << ": " << fault << "; the face cannot be animated\n";
    return nullptr;
  }
  return {{"ES", units.eyeSeparation},
          {"ENS", units.eyeNoseSeparation},
          {"MNS", units.mouthNoseSeparation},
          {"MW", units.mouthWidth},
          {"IRISD", units.irisDiameter}};
}

json describeBounds(const ClosedCurves& curves) {
  json bounds = json::object();
  const char* const axes[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis)
    bounds[axes[axis]] = {curves.points.col(axis).minCoeff(), curves.points.col(axis).maxCoeff()};
  return bounds;
}

/// What a compact face says of itself: its name and how far its curves are from those stored.
void addStatement(vtkFieldData* fields, json& description) {
  if (auto* name = vtkStringArray::SafeDownCast(fields->GetAbstractArray("FaceName")))
    description["face_name"] = std::string(name->GetValue(0));
  if (vtkDataArray* error = fields->GetArray("StoredError"))
    description["stored_error_mm"] = {{"rms", error->GetComponent(0, 0)}, {"max", error->GetComponent(0, 1)}};
}

std::uintmax_t fileSize(const std::string& name) {
  std::error_code none;
  const std::uintmax_t size = std::filesystem::file_size(name, none);
  return none ? 0 : size;
}

json describeFace(const FacePipeline& pipeline) {
  const FaceState& state = pipeline.state();
  const FaceCurves face = knownNeutralFace(pipeline);
  const std::string name = state.curvesFile.empty() ? "generic face" : state.curvesFile;
  json description;
  description["name"] = name;
  description["curves"] = face.curves.count;
  description["patches"] = FaceLayout::patchCount;
  description["points_per_curve"] = face.curves.pointsPerCurve;
  description["bytes"] = face.curves.points.size() * bytesPerCoordinate;
  description["units"] = "mm";
  description["bounds"] = describeBounds(face.curves);
  description["feature_points"] = face.features.size();
  description["feature_ids"] = json::array();
  for (const FeaturePoint& feature : face.features) description["feature_ids"].push_back(feature.id);
  description["crossings"] = namedCrossings(face.curves);
  addStatement(pipeline.neutralCurves()->GetOutput()->GetFieldData(), description);
  if (!state.curvesFile.empty()) description["file_bytes"] = fileSize(state.curvesFile);
  description["fapu"] = describeUnits(face, name);
  description["rows"] = state.rows;
  description["columns"] = state.columns;
  description["curves_missed"] = RowLayout(state.rows, state.uniformRows).missedCurves();
  return description;
}

void printExtents(const json& bounds) {
  std::string text;
  for (const auto& axis : bounds.items())
    text += (text.empty() ? "" : ", ") + axis.key() + " " + twoDigits(axis.value()[0]) + " .. " +
            twoDigits(axis.value()[1]);
  printLine("bounds (mm)", text);
}

void printFace(const json& face) {
  printLine("face", face["name"]);
  printLine("curves", face["curves"].dump() + ", closed, " + face["points_per_curve"].dump() + " points each");
  printLine("patches", face["patches"].dump());
  printLine("size", face["bytes"].dump() + " bytes in single precision");
  printExtents(face["bounds"]);
  if (face.contains("face_name")) printLine("name", face["face_name"]);
  if (face.contains("stored_error_mm"))
    printLine("stored error", roundedText(face["stored_error_mm"]["rms"]) + " mm RMS, at most " +
                                  roundedText(face["stored_error_mm"]["max"]) + " mm");
  if (face.contains("file_bytes")) printLine("file", face["file_bytes"].dump() + " bytes");
  const std::string crossings = face["crossings"];
  printLine("crossings", crossings.empty() ? "none" : crossings);
  printLine("feature points", face["feature_points"].dump() + ": " + joined(face["feature_ids"]));
  for (const auto& unit : face["fapu"].items()) printLine(unit.key(), twoDigits(unit.value()) + " mm");
  printLine("uv mesh", face["rows"].dump() + " rows x " + face["columns"].dump() + " columns");
  printLine("curves missed", joined(face["curves_missed"]));
}

json aboutFace(const InfoCommandOptions& options) {
  FaceOptions face = options.face;
  if (!options.file.empty()) face.setDefaultFace(options.file);
  FacePipeline pipeline;
  face.apply(pipeline);
  return describeFace(pipeline);
}

/// In how many frames lips or lids of the face would cross, were they not kept apart.
json describeContact(const InfoCommandOptions& options) {
  FaceOptions face = options.face;
  face.setAnimation(options.file);
  FacePipeline pipeline;
  face.apply(pipeline);
  FaceState state = pipeline.state();
  ContactCount contact;
  ProgressLine progress(pipeline.frames()->GetNumberOfFrames());
  for (; state.frame < pipeline.frames()->GetNumberOfFrames(); ++state.frame) {
    progress.show(contact.frames);
    pipeline.setState(state);
    const std::string fault = pipeline.updateCurves();
    if (!fault.empty()) throw FileFailure(fault);
    contact.add(pipeline);
  }
  return {{"frames", contact.clamped}, {"largest_mm", contact.largest}};
}

/// A kind of file that a describer of its own knows.
struct InfoKind {
  const char* name;                           ///< of the object in JSON
  json (*describe)(const std::string& file);  ///< null for other files
  void (*print)(const json& about);
};

constexpr InfoKind kinds[] = {{"table", describeTableFile, printTableFile},
                              {"scan", describeScanFile, printScanFile},
                              {"figure", describeFigureFile, printFigureFile},
                              {"picture", describePictureFile, printPictureFile},
                              {"json", describeJsonFile, printJsonFile}};

void deliver(const InfoCommandOptions& options, const char* name, const json& about, void (*print)(const json&)) {
  if (options.json)
    std::cout << json{{name, about}}.dump(2, ' ', false, json::error_handler_t::replace) << "\n";
  else
    print(about);
}

void run(const InfoCommandOptions& options) {
  for (const InfoKind& kind : kinds) {
    const json about = kind.describe(options.file);
    if (!about.is_null()) return deliver(options, kind.name, about, kind.print);
  }
  const std::string ending = fileEnding(options.file);
  const bool isAnimation = ending == "fap" || ending == "csv" || options.file == "-";
  json about = isAnimation ? describeAnimation(options.file) : aboutFace(options);
  if (isAnimation && options.json && options.file != "-") about["contact"] = describeContact(options);
  isAnimation ? deliver(options, "fap", about, printAnimation) : deliver(options, "face", about, printFace);
}

}  // namespace

void addInfoCommand(CLI::App& program) {
  const auto options = std::make_shared<InfoCommandOptions>();
  CLI::App* command = program.add_subcommand("info", "Tell what a file or the generic face holds");
  command->add_option(
      "file", options->file,
      "Boundary curves .vtp .mienz, animation .fap .csv, facial deformation table or markers .csv .fdt, scan "
      ".ply .obj .stl .off, photograph .png .jpg .tif, its mesh or landmarks .csv, figure .svg .pdf .png, session, "
      "animation table, study or map .json [the generic face]");
  command->add_flag("--json", options->json, "Machine-readable");
  options->face.addSurfaceOptions(*command);
  command->footer(
      "Example: mien info --json\n         mien info speech.fap\n         mien info take.csv\n         mien info "
      "scan.ply\n         mien info "
      "--resolution 60x40");
  command->callback([options] { run(*options); });
}

}  // namespace mien
