#include <CLI/CLI.hpp>
#include <map>
#include <memory>

#include "Arguments.h"
#include "BoundaryCurveData.h"
#include "Command.h"
#include "CurveEdit.h"
#include "FaceLayout.h"
#include "FaceOptions.h"
#include "FacePipeline.h"
#include "Failure.h"
#include "OutputFile.h"
#include "PolyDataFile.h"
#include "vtkAlgorithm.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkPolyData.h"

namespace mien {

namespace {

/// One edit as its options give it.
struct EditText {
  std::string curve, v, feature, move, width, spread;
  bool mirrored = false;
};

struct EditCommandOptions {
  std::string face, output;
  std::vector<std::string> curve, v, feature, move, width,
      spread;  ///< as CLI11 collects them; their order is in parse_order()
  bool mirror = false;
};

/// Deals the options to edits in the order in which they were given: --curve or --feature begins one, unless the edit
/// before has none yet.
class EditReader {
 public:
  std::vector<EditText> read(const CLI::App& command) {
    for (const CLI::Option* option : command.parse_order()) take(*option);
    return edits_;
  }

 private:
  void take(const CLI::Option& option) {
    const std::string name = option.get_lnames().empty() ? "" : option.get_lnames().front();
    if (name == "face" || name == "output") return;
    const bool begins = (name == "curve" || name == "feature") && !(edits_.empty() ? false : canJoin(name));
    if (begins) edits_.emplace_back();
    if (edits_.empty()) throw ValueFailure("--" + name + " belongs to an edit; begin each with --curve or --feature");
    EditText& edit = edits_.back();
    if (name == "mirror") {
      edit.mirrored = true;
      return;
    }
    const std::map<std::string, std::string*> places = {{"curve", &edit.curve},     {"v", &edit.v},
                                                        {"feature", &edit.feature}, {"move", &edit.move},
                                                        {"width", &edit.width},     {"spread", &edit.spread}};
    std::string& place = *places.at(name);
    if (!place.empty())
      throw ValueFailure("--" + name + " is given twice for one edit; begin the next edit with --curve or --feature");
    place = option.results()[next_[name]++];
  }

  /// --curve C6 --feature 4.1 is one edit: the curve at the v of a feature point.
  bool canJoin(const std::string& name) const {
    const EditText& last = edits_.back();
    return last.move.empty() && (name == "feature" ? last.feature.empty() && last.v.empty() : last.curve.empty());
  }

  std::vector<EditText> edits_;
  std::map<std::string, size_t> next_;
};

Eigen::Vector3d parseMove(const std::string& text) {
  const std::vector<std::string> parts = splitText(text, ',');
  if (parts.size() != 3) throw ValueFailure("--move '" + text + "' is no move; give three numbers of mm as 0,2.5,0");
  return {parseNumber("--move", parts[0]), parseNumber("--move", parts[1]), parseNumber("--move", parts[2])};
}

std::string featureNames(const FaceCurves& face) {
  std::string names;
  for (const FeaturePoint& feature : face.features) names += (names.empty() ? "" : ", ") + feature.id;
  return names.empty() ? "none" : names;
}

CurveEdit editOf(const EditText& text, const FaceCurves& face) {
  CurveEdit edit;
  if (!text.feature.empty()) {
    const FeaturePoint* feature = face.feature(text.feature);
    if (!feature)
      throw ValueFailure("--feature " + text.feature + " is not on this face; it has " + featureNames(face));
    edit.curve = feature->curve;
    edit.v = feature->v;
  }
  if (!text.curve.empty()) {
    edit.curve = FaceLayout::curveIndex(text.curve);
    if (edit.curve < 0) throw ValueFailure("--curve '" + text.curve + "' is unknown; curves are C1 .. C28 and C22'");
  }
  if (text.feature.empty() && (text.curve.empty() || text.v.empty()))
    throw ValueFailure("an edit needs --curve and --v, or --feature");
  if (!text.v.empty()) edit.v = parseNumber("--v", text.v);
  if (text.move.empty()) throw ValueFailure("an edit needs --move dx,dy,dz (mm)");
  edit.move = parseMove(text.move);
  if (!text.width.empty()) edit.width = parseNumber("--width", text.width) * M_PI / 180.0;
  if (!text.spread.empty()) edit.spread = parseWholeNumber("--spread", text.spread);
  edit.mirrored = text.mirrored;
  return edit;
}

FaceCurves neutralFace(FacePipeline& pipeline) {
  const std::string fault = pipeline.updateNeutralCurves();
  if (!fault.empty()) throw FileFailure(fault);
  FaceCurves face;
  const std::string faceFault = readFaceCurves(pipeline.neutralCurves()->GetOutput(), face);
  if (!faceFault.empty()) throw FileFailure(faceFault);
  return face;
}

void run(const EditCommandOptions& options, const CLI::App& command) {
  requireEnding(options.output, {"vtp"});
  FacePipeline pipeline;
  FaceState state;
  state.curvesFile = options.face;
  pipeline.setState(state);
  FaceCurves face = neutralFace(pipeline);
  for (const EditText& text : EditReader().read(command)) state.edits.push_back(editOf(text, face));
  if (state.edits.empty()) throw ValueFailure("there is no edit; give --curve and --v, or --feature, and --move");
  std::string fault = applyEdits(state.edits, face);
  if (!fault.empty()) throw ValueFailure(fault);
  pipeline.setState(state);
  fault = pipeline.updateCurves();
  if (!fault.empty()) throw FileFailure(fault);
  writePolyData(vtkPolyData::SafeDownCast(pipeline.curves()->GetOutputDataObject(0)), options.output);
}

}  // namespace

void addEditCommand(CLI::App& program) {
  const auto options = std::make_shared<EditCommandOptions>();
  CLI::App* command = program.add_subcommand("edit", "Move points of boundary curves by hand, with a smooth fall-off");
  const auto add = [&](const char* name, std::vector<std::string>& values, const char* help) {
    command->add_option(name, values, help)
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->group("Edits");
  };
  command->add_option("--face", options->face, "Boundary curves, FILE.vtp [the generic face]");
  add("--curve", options->curve, "Curve of the point, C1 .. C28 or C22'");
  add("--v", options->v, "Where on the curve, radians; pi is the middle of the face, more the subject's left");
  add("--feature", options->feature, "A feature point such as 4.1: its curve and v");
  add("--move", options->move, "dx,dy,dz in mm; +x the subject's left, +y up, +z forward");
  add("--width", options->width, "Where along v the fall-off ends, degrees on either side [25]");
  add("--spread", options->spread, "Neighbouring curves that follow on either side [1]");
  command->add_flag("--mirror", options->mirror, "The other side of the face moves as the mirror image")
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
      ->group("Edits");
  command->add_option("-o,--output", options->output, "File to write: .vtp")->required();
  command->footer(
      "Each --curve or --feature begins an edit; they are made one after the other. Edits that make curves cross are "
      "refused.\n"
      "Example: mien edit --feature 4.1 --move 0,3,0 --mirror --spread 2 -o raised.vtp\n"
      "         mien edit --face anna.vtp --curve C15 --v 3.1416 --move 0,0,4 --curve C28 --v 3.1416 --move 0,-2,3 -o "
      "changed.vtp");
  command->callback([options, command] { run(*options, *command); });
}

}  // namespace mien
