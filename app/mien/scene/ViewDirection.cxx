#include "ViewDirection.h"

#include <cmath>
#include <map>

#include "Arguments.h"
#include "Failure.h"
#include "vtkMath.h"

namespace mien {

namespace {

// Straight above, the head's own up direction would point along the view.
constexpr double steepest = 89.0;

const std::map<std::string, ViewDirection> namedViews = {
    {"front", {0, 0}},   {"back", {180, 0}},     {"left", {90, 0}},    {"side", {90, 0}},
    {"right", {-90, 0}}, {"top", {0, steepest}}, {"45-left", {45, 0}}, {"45-right", {-45, 0}}};

ViewDirection parseAngles(const std::string& text) {
  const std::vector<std::string> parts = splitText(text, ':');
  ViewDirection view;
  view.azimuth = parseNumber("--view", parts[0]);
  if (parts.size() == 2) view.elevation = parseNumber("--view", parts[1]);
  if (parts.size() > 2 || std::abs(view.elevation) > steepest) throw ValueFailure("");
  return view;
}

}  // namespace

void ViewDirection::unitVector(double direction[3]) const {
  const double a = azimuth * M_PI / 180.0, e = elevation * M_PI / 180.0;
  direction[0] = std::sin(a) * std::cos(e);
  direction[1] = std::sin(e);
  direction[2] = std::cos(a) * std::cos(e);
}

void ViewDirection::axes(double right[3], double up[3], double out[3]) const {
  const double angle = azimuth * M_PI / 180.0;
  unitVector(out);
  right[0] = std::cos(angle), right[1] = 0.0, right[2] = -std::sin(angle);
  vtkMath::Cross(out, right, up);
}

ViewDirection parseView(const std::string& text) {
  const auto named = namedViews.find(text);
  if (named != namedViews.end()) return named->second;
  try {
    return parseAngles(text);
  } catch (const ValueFailure&) {
    throw ValueFailure("--view '" + text +
                       "' is unknown; it is front, side, left, right, back, top, 45, 45-right, or degrees as "
                       "AZIMUTH:ELEVATION with elevations of -89 .. 89");
  }
}

}  // namespace mien
