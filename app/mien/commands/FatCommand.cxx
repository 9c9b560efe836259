#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "AnimationData.h"
#include "AnimationTable.h"
#include "BoundaryCurveData.h"
#include "Command.h"
#include "FAPTable.h"
#include "FaceAnimator.h"
#include "Failure.h"
#include "InfoText.h"
#include "PipelineErrors.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace mien {

namespace {

using json = nlohmann::ordered_json;

struct FatCommandOptions {
  std::string file, face;
  bool json = false;
};

FaceCurves readBoundaryCurves(const std::string& fileName) {
  vtkNew<vtkBoundaryCurveReader> reader;
  PipelineErrors errors;
  errors.observe(reader);
  if (!fileName.empty()) reader->SetFileName(fileName.c_str());
  reader->Update();
  if (!errors.first().empty()) throw FileFailure(errors.first());
  FaceCurves face;
  const std::string fault = readFaceCurves(reader->GetOutput(), face);
  if (!fault.empty()) throw FileFailure((fileName.empty() ? "generic face" : fileName) + ": " + fault);
  return face;
}

/// FAPs with surface that the table says nothing about; the angles of the head need no entry.
std::vector<int> missingFAPs(const AnimationTable& table) {
  std::vector<int> missing;
  for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count; ++fap) {
    const FAPDefinition& definition = fapDefinition(fap);
    if (definition.hasSurface && definition.unit != FAPUnit::Angle && !table.entry(fap)) missing.push_back(fap);
  }
  return missing;
}

json curvesMoved(const AnimationTable& table) {
  std::set<int> curves;
  for (const AnimationEntry& entry : table.entries())
    for (const AnimationPart& part : entry.parts) curves.insert(part.curves.begin(), part.curves.end());
  json names = json::array();
  for (int curve : curves) names.push_back(FaceLayout::curveName(curve));
  return names;
}

json describeContents(const AnimationTable& table) {
  json faps = json::array(), contacts = json::array();
  std::set<std::string> points;
  for (const AnimationEntry& entry : table.entries()) {
    faps.push_back(entry.fap);
    points.insert(std::string(fapDefinition(entry.fap).featurePoint));
  }
  for (const ContactPair& pair : table.contacts())
    contacts.push_back(pair.name + " (" + FaceLayout::curveName(pair.upper) + ", " + FaceLayout::curveName(pair.lower) +
                       ")");
  return {{"version", table.fileVersion()},     {"faps", faps},
          {"faps_missing", missingFAPs(table)}, {"curves", curvesMoved(table)},
          {"feature_points", points},           {"contacts", contacts}};
}

/// Binds the table to the face: the FAPs that this face leaves out, as it lacks their feature point.
json describeBinding(const AnimationTable& table, const FatCommandOptions& options) {
  FaceAnimator animator;
  const std::string name = options.face.empty() ? "generic face" : options.face;
  const std::string fault = animator.bind(readBoundaryCurves(options.face), table);
  if (!fault.empty()) throw FileFailure(options.file + ": on the " + name + ": " + fault);
  json leftOut = json::array();
  for (const AnimationEntry& entry : table.entries())
    if (!animator.basis().motion(entry.fap)) leftOut.push_back(entry.fap);
  return {{"face", name}, {"left_out", leftOut}};
}

void print(const json& description) {
  printLine("animation table", description["file"]);
  printLine("version", description["version"].dump());
  printLine("FAPs moved", joined(description["faps"]));
  printLine("not in it", joined(description["faps_missing"]));
  printLine("curves moved", joined(description["curves"]));
  printLine("feature points", joined(description["feature_points"]));
  printLine("contacts", joined(description["contacts"]));
  printLine("binds to", description["face"]);
  printLine("left out there", joined(description["left_out"]));
}

void check(const FatCommandOptions& options) {
  AnimationTable table;
  const std::string fault = readAnimationTable(options.file, table);
  if (!fault.empty()) throw FileFailure(fault);
  json description = {{"file", options.file}};
  description.update(describeContents(table));
  description.update(describeBinding(table, options));
  if (options.json)
    std::cout << description.dump(2) << "\n";
  else
    print(description);
}

}  // namespace

void addFatCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand("fat", "Animation tables: which points of the curves each FAP moves");
  command->require_subcommand(1);
  const auto options = std::make_shared<FatCommandOptions>();
  CLI::App* checking = command->add_subcommand("check", "Tell what a table holds, or what is wrong with it");
  checking->add_option("file", options->file, "Animation table, FILE.json")->required();
  checking->add_option("--face", options->face, "Boundary curves it must serve, FILE.vtp [the generic face]");
  checking->add_flag("--json", options->json, "Machine-readable");
  checking->footer(
      "Example: mien fat check my_table.json --face anna.vtp\n"
      "A table is used with --fat; doc/animation_table.md describes the format.");
  checking->callback([options] { check(*options); });
}

}  // namespace mien
