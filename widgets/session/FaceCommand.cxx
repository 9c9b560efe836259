#include "FaceCommand.h"

#include <vtkCamera.h>

#include <algorithm>
#include <cmath>

#include "FaceArguments.h"
#include "FaceModel.h"
#include "FaceView.h"

namespace mien {

namespace {

constexpr double degreesPerRadian = 180.0 / M_PI;
constexpr long steepest = 89;                                    // degrees that --view takes
constexpr const char* styles[] = {"", "wireframe", "both", ""};  // of FaceView::Mesh; of points there is none

/// AZIMUTH:ELEVATION of the camera around the head, whole degrees; empty from the front.
std::string viewText(const FaceView& view) {
  double direction[3];
  view.camera()->GetDirectionOfProjection(direction);
  const long azimuth = std::lround(degreesPerRadian * std::atan2(-direction[0], -direction[2]));
  const long elevation =
      std::clamp(std::lround(degreesPerRadian * std::asin(std::clamp(-direction[1], -1.0, 1.0))), -steepest, steepest);
  if (azimuth == 0 && elevation == 0) return {};
  return std::to_string(azimuth) + (elevation == 0 ? "" : ":" + std::to_string(elevation));
}

}  // namespace

QString renderCommand(const FaceModel& model, const FaceView& view, const FaceLook& look) {
  std::vector<std::string> words = {"mien", "render"};
  for (const std::string& word : faceArguments(model.lastingState())) words.push_back(word);
  const std::string style = styles[static_cast<int>(view.mesh())];
  if (!style.empty()) words.insert(words.end(), {"--style", style});
  if (!look.array.empty()) words.insert(words.end(), {"--color-by", look.array});
  if (look.hasCurves) words.push_back("--curves");
  if (const std::string direction = viewText(view); !direction.empty()) words.push_back("--view=" + direction);
  words.push_back("-o");
  words.push_back("face.png");
  return QString::fromStdString(shellText(words));
}

}  // namespace mien
