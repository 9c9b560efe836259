#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "Acquire.h"
#include "Arguments.h"
#include "Command.h"
#include "Failure.h"
#include "Interruption.h"
#include "NumberText.h"
#include "OutputFile.h"
#include "ProgressLine.h"
#include "ScanUnit.h"

namespace mien {

namespace {

using json = nlohmann::ordered_json;

constexpr int smallestCurve = 8, largestCurve = 4096;  // points
constexpr double doubtfulDepth = 1.0;  // mm; another head's landmarks seldom lie nearer: doc/decisions.md

struct AcquireCommandOptions {
  AcquireOptions acquire;
  ScanUnit unit;
  std::string pose = "auto";
  bool json = false;
};

ScanSettings::Pose poseOf(const std::string& name) {
  if (name == "auto") return ScanSettings::Pose::Automatic;
  if (name == "keep") return ScanSettings::Pose::Kept;
  if (name == "move") return ScanSettings::Pose::Moved;
  throw ValueFailure("--pose '" + name + "' is unknown; it is auto, keep or move");
}

void check(const AcquireOptions& options) {
  requireEnding(options.outputFile, {"vtp"});
  if (!options.landmarkOutput.empty()) requireEnding(options.landmarkOutput, {"csv"});
  if (!options.scanOutput.empty()) requireEnding(options.scanOutput, {"vtp"});
  if (options.scans.size() > 1 && !options.mean)
    throw ValueFailure("several scans make one face only as their mean; add --mean, or give one scan");
  if (options.scans.size() > 1 && !options.scanOutput.empty())
    throw ValueFailure("--scan-output takes one scan; give one, or leave the option out");
  const int k = options.scan.pointsPerCurve;
  if (k < smallestCurve || k > largestCurve || k % 2 != 0)
    throw ValueFailure("--points " + std::to_string(k) + " is not allowed; it is an even number from " +
                       std::to_string(smallestCurve) + " to " + std::to_string(largestCurve));
  if (options.triangles != 0 && options.triangles < 1000)
    throw ValueFailure("--decimate " + std::to_string(options.triangles) +
                       " is not allowed; it is 1000 triangles or more");
}

json matrixOf(const Similarity& motion) {
  json rows = json::array();
  for (int r = 0; r < 3; ++r) {
    const Eigen::RowVector3d row = motion.scale * motion.rotation.row(r);
    rows.push_back({row[0], row[1], row[2], motion.translation[r]});
  }
  rows.push_back({0.0, 0.0, 0.0, 1.0});
  return rows;
}

json jsonOf(const AcquireResult& result) {
  const ScanReport& r = result.report;
  json object = {{"scan", result.scan},
                 {"unit", r.unit.empty() ? json(nullptr) : json(r.unit)},
                 {"mm_per_unit", r.millimetres},
                 {"unit_recognised", r.unitRecognised},
                 {"eye_distance_mm", r.eyes},
                 {"pose", r.moved ? "moved" : "kept"},
                 {"turned_degrees", r.turned * 180.0 / M_PI},
                 {"scan_to_face", matrixOf(r.scanToFace)},
                 {"triangles", r.triangles},
                 {"merged_vertices", r.mergedVertices},
                 {"degenerate_triangles", r.degenerateTriangles},
                 {"parts", r.parts},
                 {"dropped_parts", r.droppedParts},
                 {"face_part", r.facePart + 1},
                 {"winds_inwards", r.windsInwards},
                 {"holes", r.holes},
                 {"landmarks", r.landmarksGiven ? "given" : "fitted"},
                 {"completed_landmarks", r.completedLandmarks}};
  if (r.fitted) object["fit"] = {{"rms_mm", r.fitDistance}, {"relief", r.fitRelief}, {"size", r.fitSize}};
  if (r.fitted && r.landmarksGiven)
    object["landmark_residual"] = {{"rms_mm", r.landmarkRMS}, {"max_mm", r.landmarkMaximum}};
  if (r.landmarksGiven) object["landmark_depth_mm"] = r.landmarkDepth;
  if (!r.uncomparedReason.empty()) object["landmark_residual"] = {{"missing", r.uncomparedReason}};
  object["frontal_distance"] = {{"rms_mm", result.frontalRMS}, {"max_mm", result.frontalMaximum}};
  object["crossings"] = result.crossings;
  if (result.crossings > 0) object["crossing_curves"] = result.crossingCurves;
  return object;
}

/// What was assumed is said without --report as well.
void remark(const AcquireResult& result) {
  const ScanReport& r = result.report;
  ScanUnit::remark(result.scan, r);
  if (r.moved)
    std::cerr << "mien: " << result.scan
              << ": the head was moved onto the generic face; --pose keep leaves it where it is\n";
  if (r.windsInwards)
    std::cerr
        << "mien: " << result.scan
        << ": the faces wind inwards: the scan may be mirrored (left-handed), its left being its right; where it is "
           "not, all is well\n";
  if (r.facePart > 0 && r.droppedParts > 0)
    std::cerr << "mien: " << result.scan << ": the face lies on part " << r.facePart + 1 << " of " << r.parts
              << " by area; the larger ones were left out (--all-parts keeps them)\n";
  if (r.landmarkDepth > doubtfulDepth)
    std::cerr << "mien: " << result.scan << ": the landmarks lie " << roundedText(r.landmarkDepth)
              << " mm (median) off the scan; are they of this head?\n";
  if (result.crossings > 0)
    std::cerr << "mien: " << result.scan << ": curves cross: " << result.crossingCurves
              << "; the surface is folded there; look at holes of the scan and at the landmarks beside them\n";
  if (!r.uncomparedReason.empty())
    std::cerr << "mien: " << result.scan
              << ": the landmarks could not be compared with fitted ones: " << r.uncomparedReason << "\n";
  if (!r.landmarksGiven)
    std::cerr << "mien: " << result.scan
              << ": landmarks were fitted; --landmark-output writes them, so that they can be mended\n";
}

void deliver(const AcquireCommandOptions& options, const std::vector<AcquireResult>& results) {
  json all = json::array();
  for (const AcquireResult& result : results) {
    remark(result);
    if (options.json)
      all.push_back(jsonOf(result));
    else if (options.acquire.report)
      std::cout << reportText(result) << matrixText(result.report);
  }
  if (options.json) std::cout << all.dump(2) << "\n";
}

void run(const AcquireCommandOptions& given) {
  AcquireOptions options = given.acquire;
  check(options);
  options.scan.millimetres = given.unit.millimetres();
  options.scan.pose = poseOf(given.pose);
  options.report = options.report || given.json;
  OutputFile curves(options.outputFile);
  std::optional<OutputFile> landmarks, scan;
  options.outputFile = curves.temporaryName();
  if (!options.landmarkOutput.empty())
    options.landmarkOutput = landmarks.emplace(options.landmarkOutput).temporaryName();
  if (!options.scanOutput.empty()) options.scanOutput = scan.emplace(options.scanOutput).temporaryName();
  noteInterruptions();
  std::vector<AcquireResult> results;
  std::string fault;
  {
    ProgressLine line;
    fault = acquire(options, &results, [&](double done) {
      line.showShare(done);
      return !wasInterrupted();
    });
  }
  if (wasInterrupted()) throw Stopped("stopped before the curves were measured; nothing was written");
  if (!fault.empty()) throw FileFailure(fault);
  if (landmarks) landmarks->commit();
  if (scan) scan->commit();
  curves.commit();
  deliver(given, results);
}

constexpr const char* landmarkHelp =
    "Landmarks are the 68 of Multi-PIE, numbered 0 .. 67 (0-16 jaw, 17-26 brows, 27-35 nose, 36-47 eyes, 48-67 lips, "
    "from the\n"
    "subject's right). Twelve must be given, by number or name, the others are completed:\n"
    "  8 chin, 27 nose_bridge, 30 nose_tip, 33 nose_base, 36 right_eye_outer, 39 right_eye_inner, 42 "
    "left_eye_inner,\n"
    "  45 left_eye_outer, 48 right_mouth_corner, 51 upper_lip, 54 left_mouth_corner, 57 lower_lip.\n"
    "Example: mien acquire anna.ply -o anna.vtp --report\n"
    "         mien acquire anna.obj --landmarks anna68.csv --units cm -o anna.vtp\n"
    "         mien acquire heads/*.ply --landmarks landmarks68.csv --mean -o mean.vtp";

}  // namespace

void addAcquireCommand(CLI::App& program) {
  const auto options = std::make_shared<AcquireCommandOptions>();
  AcquireOptions& acquire = options->acquire;
  CLI::App* command = program.add_subcommand("acquire", "Measure the boundary curves of a face from scans of heads");
  command->add_option("scans", acquire.scans, "Scans of whole heads in any unit and pose: .ply .obj .stl .off")
      ->required();
  command->add_option("--landmarks", acquire.landmarkFile,
                      "FILE.csv with the columns landmark,vertex or landmark,x,y,z; serves all scans [found by fitting "
                      "the generic face]");
  options->unit.addTo(*command);
  command
      ->add_option("--pose", options->pose,
                   "auto: upright heads stay, others are moved onto the generic face; keep; move")
      ->capture_default_str();
  command->add_option("--decimate", acquire.triangles, "Triangles left before measuring, by quadric error [all]");
  command->add_flag("--all-parts", acquire.scan.allParts,
                    "Loose parts count too, not only the largest and the eyeballs");
  command->add_flag("--nostrils", acquire.scan.nostrils,
                    "Curves go into the nostrils, as those of the generic face do, instead of from rim to rim");
  command->add_flag("--mean", acquire.mean, "The symmetric mean of all scans");
  command->add_option("--points", acquire.scan.pointsPerCurve, "Points per curve, even")->capture_default_str();
  command->add_flag("--report", acquire.report,
                    "Print unit, pose, residuals, distance to the scan, holes and crossings");
  command->add_flag("--json", options->json, "The report as JSON");
  command->add_option("-o,--output", acquire.outputFile, "File to write: .vtp")->required();
  command->add_option(
      "--landmark-output", acquire.landmarkOutput,
      "The landmarks in the scan's own frame and unit, to be given as --landmarks, .csv; with --mean in that of the "
      "curves");
  command->add_option("--scan-output", acquire.scanOutput, "The scan in the frame of the curves, mm, .vtp");
  command->footer(landmarkHelp);
  command->callback([options] { run(*options); });
}

}  // namespace mien
