#include "VectorDrawing.h"

#include <CLI/CLI.hpp>
#include <cctype>
#include <map>

#include "Arguments.h"
#include "Failure.h"
#include "VectorColors.h"
#include "ViewDirection.h"

namespace mien {

namespace {

constexpr double leastScale = 1e-6, largestScale = 1e6;  // mm per mm

template <class Choice>
Choice choose(const std::string& option, const std::string& text, const std::map<std::string, Choice>& known) {
  const auto found = known.find(text);
  if (found != known.end()) return found->second;
  std::string names;
  for (const auto& [name, choice] : known) names += (names.empty() ? "" : ", ") + name;
  throw ValueFailure(option + " '" + text + "' is unknown; the known ones are " + names);
}

std::string mapNames() {
  std::string names;
  for (const ColorTable& table : ColorTable::all()) names += (names.empty() ? "" : ", ") + table.name;
  return names;
}

}  // namespace

void VectorDrawing::addTo(CLI::App& command) {
  const char* const group = "Figure";
  const auto add = [&](const char* name, std::string& value, const std::string& help) {
    return command.add_option(name, value, help)->group(group);
  };
  add("--view", view_, "front, side, left, right, back, top, 45, 45-right, or degrees AZIMUTH[:ELEVATION]")
      ->capture_default_str();
  add("--region", region_,
      "What is looked at: a patch P0 .. P8; " + VectorRegion::names() +
          "; or XMIN,YMIN,XMAX,YMAX in mm to the right and up in the picture [all]");
  command.add_flag("--whole-face", wholeFace_, "Show a region within the whole face, not enlarged")->group(group);
  add("--sample", sample_,
      "even:SPACING, evenly in the picture, mm on the face; every:N, every N-th vertex; auto: figures evenly, arrows "
      "about 2.4 mm apart in print, tables with all vertices")
      ->capture_default_str();
  command.add_flag("--hidden", hidden_, "Draw vectors behind the face too")->group(group);
  add("--scale", scale_, "mm of motion in 1 mm of arrow; auto: a round one; face: as large as the face is drawn")
      ->capture_default_str();
  add("--range", range_, "MIN:MAX, mm at the ends of the colours [from the arrows that are drawn]");
  add("--length", length_, "Of arrows: seen (projected, as the face is), space (in three dimensions), equal")
      ->capture_default_str();
  add("--color", color_, "Of arrows: space (length in three dimensions), towards (component towards the viewer), none")
      ->capture_default_str();
  add("--colormap", colorMap_,
      mapNames() +
          "; with _r turned around; auto: viridis, coolwarm for --color towards. On light themes maps end before their "
          "palest colours, which nobody sees on white: viridis at a green")
      ->capture_default_str();
  command.add_flag("--no-seams", noSeams_, "Leave out the lines between patches")->group(group);
  add("--columns", columns_, "Panels beside each other [as many as fit]");
  command.add_flag("--bare", bare_, "No title, caption and note")->group(group);
  file_.addTo(command, group);
}

void VectorDrawing::check() const {
  file_.check();
  options();
}

MotionVectorOptions VectorDrawing::options() const {
  MotionVectorOptions options;
  fillPicture(options);
  fillScale(options);
  fillRange(options);
  fillColors(options);
  options.seams = !noSeams_;
  options.theme = file_.theme();
  options.width = file_.width();
  if (!columns_.empty()) options.columns = parseWholeNumber("--columns", columns_);
  if (!columns_.empty()) requireRange("--columns", options.columns, 1, 100);
  return options;
}

void VectorDrawing::fillPicture(MotionVectorOptions& options) const {
  Eigen::Vector3d direction;
  parseView(view_).unitVector(direction.data());
  options.picture.plane.look(direction, Eigen::Vector3d::UnitY());
  const std::string fault = options.picture.sampling.parse(sample_);
  if (!fault.empty()) throw ValueFailure("--sample: " + fault);
  options.picture.hidden = hidden_;
  options.picture.wholeFrame = wholeFace_;
}

void VectorDrawing::fillScale(MotionVectorOptions& options) const {
  options.trueToFace = scale_ == "face";
  if (scale_ == "auto" || scale_ == "face") return;
  options.scale = parseNumber("--scale", scale_);
  if (!(*options.scale >= leastScale && *options.scale <= largestScale))
    throw ValueFailure("--scale '" + scale_ + "' is outside 1e-6 .. 1e6; 2 means 2 mm of motion in 1 mm of arrow");
}

void VectorDrawing::fillRange(MotionVectorOptions& options) const {
  if (range_.empty()) return;
  const std::vector<std::string> ends = splitText(range_, ':');
  if (ends.size() != 2) throw ValueFailure("--range '" + range_ + "' is no range; write MIN:MAX in mm, such as 0:8");
  options.range = {parseNumber("--range", ends[0]), parseNumber("--range", ends[1])};
  if (!((*options.range)[0] < (*options.range)[1]))
    throw ValueFailure("--range '" + range_ + "' is empty; its first number is the smaller one");
}

void VectorDrawing::fillColors(MotionVectorOptions& options) const {
  using Length = MotionVectorOptions::Length;
  using Color = MotionVectorOptions::Color;
  options.length = choose<Length>("--length", length_,
                                  {{"seen", Length::Seen}, {"space", Length::InSpace}, {"equal", Length::Equal}});
  options.color = choose<Color>("--color", color_,
                                {{"space", Color::Magnitude}, {"towards", Color::Towards}, {"none", Color::None}});
  if (colorMap_ == "auto") return;
  if (!VectorColors::isKnown(colorMap_))
    throw ValueFailure("--colormap '" + colorMap_ + "' is unknown; the known ones are " + mapNames() +
                       ", each also with _r");
  options.colorMap = colorMap_;
}

std::string VectorDrawing::viewName() const {
  const std::string degree = "\u00b0";
  if (view_.empty() || !(std::isdigit(static_cast<unsigned char>(view_[0])) || view_[0] == '-' || view_[0] == '+'))
    return view_;
  const size_t colon = view_.find(':'), dash = view_.find("-right");
  if (colon != std::string::npos)
    return "azimuth " + view_.substr(0, colon) + degree + ", elevation " + view_.substr(colon + 1) + degree;
  return dash == std::string::npos ? view_ + degree : view_.substr(0, dash) + degree + " right";
}

void VectorDrawing::chooseRegion(const FaceCurves* face, MotionVectorOptions& options) const {
  if (region_.empty()) return;
  const std::string fault = options.picture.region.parse(region_, face);
  if (!fault.empty()) throw ValueFailure("--region: " + fault);
}

}  // namespace mien
