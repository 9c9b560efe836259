#include "RenderOptions.h"

#include <CLI/CLI.hpp>
#include <map>

#include "Arguments.h"
#include "FaceOptions.h"
#include "Failure.h"
#include "vtkNamedColors.h"
#include "vtkNew.h"

namespace mien {

namespace {

constexpr int shadedRows = 164, shadedColumns = 160;

std::array<double, 3> parseColor(const std::string& text) {
  vtkNew<vtkNamedColors> names;
  std::array<double, 3> color;
  const bool hexadecimal =
      text.size() == 7 && text[0] == '#' && text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
  if (!hexadecimal && !names->ColorExists(text))
    throw ValueFailure("--background '" + text + "' is no colour; write a name such as white or #1a2b3c");
  if (!hexadecimal) {
    names->GetColorRGB(text, color.data());
    return color;
  }
  for (int c = 0; c < 3; ++c) color[c] = std::stoi(text.substr(1 + 2 * c, 2), nullptr, 16) / 255.0;
  return color;
}

SceneStyle::Mesh parseMesh(const std::string& text) {
  using Mesh = SceneStyle::Mesh;
  static const std::map<std::string, Mesh> known = {
      {"shaded", Mesh::Shaded}, {"wireframe", Mesh::Wireframe}, {"both", Mesh::Both}};
  const auto found = known.find(text);
  if (found == known.end()) throw ValueFailure("--style '" + text + "' is unknown; it is shaded, wireframe or both");
  return found->second;
}

}  // namespace

void RenderOptions::addTo(CLI::App& command) {
  const auto add = [&](const char* name, std::string& value, const char* help) {
    command.add_option(name, value, help)->capture_default_str()->group("Picture");
  };
  add("--view", view_, "front, side, left, right, back, top, 45, 45-right, or degrees AZIMUTH[:ELEVATION]");
  add("--size", size_, "Width x height in pixels");
  add("--zoom", zoom_,
      "neutral: as large as the neutral face fills the picture, so that pictures compare, unless the face leaves it; "
      "fit: what is shown fills it");
  add("--style", style_, "shaded, wireframe or both");
  command.add_option("--color-by", colorBy_, "Array of the surface to colour by, with a colour bar")->group("Picture");
  command.add_flag("--curves", curves_, "Draw the boundary curves over the surface")->group("Picture");
  add("--background", background_, "Colour by name or as #rrggbb");
  command.add_flag("--transparent", transparent_, "No background")->group("Picture");
}

void RenderOptions::chooseResolution(FaceOptions& face) const {
  if (parseMesh(style_) == SceneStyle::Mesh::Shaded) face.setDefaultResolution(shadedRows, shadedColumns);
}

SceneStyle RenderOptions::style() const {
  SceneStyle style;
  std::tie(style.width, style.height) = parseSize("--size", size_);
  if (style.width > largestSide || style.height > largestSide)
    throw ValueFailure("--size " + size_ + " is too large; at most " + std::to_string(largestSide) + "x" +
                       std::to_string(largestSide) + " pixels are allowed");
  style.view = parseView(view_);
  style.mesh = parseMesh(style_);
  if (zoom_ != "neutral" && zoom_ != "fit")
    throw ValueFailure("--zoom '" + zoom_ + "' is unknown; it is neutral or fit");
  style.neutralFrame = zoom_ == "neutral";
  style.colorBy = colorBy_;
  style.curves = curves_;
  style.transparent = transparent_;
  style.background = parseColor(background_);
  return style;
}

}  // namespace mien
