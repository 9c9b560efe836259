#include <algorithm>
#include <filesystem>

#include "CatalogueFigures.h"
#include "CsvText.h"
#include "CurveDrawing.h"
#include "FaceMotion.h"
#include "FaceNote.h"
#include "FigureContext.h"
#include "FrameChoice.h"
#include "MotionPanel.h"
#include "PanelRow.h"
#include "PlaneDrawingPainter.h"

namespace mien {

namespace {

constexpr int frames = 5;
constexpr int fineRows = 164, fineColumns = 160;

PlatePanel curveRow(FigureContext& context, const std::vector<FaceState>& states) {
  std::vector<PlaneDrawing> drawings(states.size());
  QRectF shown;
  PlaneStroke thin;
  thin.width = 0.4;
  for (size_t i = 0; i < states.size(); ++i) {
    CurveDrawing(context.curves(states[i]).curves).addLines(drawings[i], [&](int) { return thin; });
    shown = shown.united(drawings[i].bounds());
  }
  std::vector<PlatePanel> panels;
  for (size_t i = 0; i < states.size(); ++i)
    panels.push_back(drawingPanel(frameHeading(states[i]), drawings[i], shown));
  return panelRow("Boundary curves", panels, context.innerWidth());
}

PlatePanel vectorRow(FigureContext& context, const std::vector<FaceState>& states) {
  std::vector<MotionVectorPanel> fields;
  for (FaceState state : states) {
    state.rows = 56;
    state.columns = 40;
    fields.push_back(
        {context.motion(state, FaceMotion::neutralOf(state)), context.isNarrow() ? frameHeading(state) : ""});
  }
  MotionVectorOptions options = context.vectorOptions();
  options.width = context.innerWidth();
  options.columns = context.isNarrow() ? 3 : std::max(3, static_cast<int>(states.size()));  // arrows must be seen
  options.labelled = false;
  options.asRow = true;
  return motionPanel("Motion against the neutral face, 56 × 40 points", fields, options);
}

/// @param heads  whether each face is named by its frame
PlatePanel texturedRow(FigureContext& context, const std::vector<FaceState>& states, size_t texture,
                       const std::string& heading, bool heads) {
  std::vector<FigureContext::NamedFace> faces;
  for (const FaceState& one : states) {
    FaceState state = context.textured(one, texture);
    state.rows = fineRows;
    state.columns = fineColumns;
    faces.push_back({heads ? frameHeading(one) : "", state});
  }
  const double width = context.innerWidth() / std::max(3.0, static_cast<double>(states.size()));
  return panelRow(heading, context.facePanels(faces, SceneStyle(), width, faceShape), context.innerWidth());
}

/// The face, the file and its frames.
std::string noteOf(const std::vector<FaceState>& states) {
  std::string frames;
  const std::string first = states.size() > 1 ? "frames " : "frame ";
  for (const FaceState& state : states) frames += (frames.empty() ? first : ", ") + shortestText(state.frame);
  return faceNote(states.front(), {states.front().surface.scheme}, true, frames);
}

/// The photograph is named where there are several.
std::string texturedHeading(const FigureContext& context, size_t texture) {
  const std::vector<std::string>& files = context.settings().textures;
  if (files.size() < 2) return "Textured";
  return "Textured: " + std::filesystem::path(files[texture].substr(0, files[texture].find(':'))).filename().string();
}

}  // namespace

FigureDrawing drawAnimation(FigureContext& context) {
  const std::vector<FaceState> states = animationStates(context, frames, 0.0, 1.0);
  Plate plate;
  plate.columns = 1;
  plate.panels = {curveRow(context, states), vectorRow(context, states)};
  const size_t textures = std::max<size_t>(context.settings().textures.size(), 1);
  for (size_t i = 0; i < textures; ++i)
    plate.panels.push_back(texturedRow(context, states, i, texturedHeading(context, i), false));
  plate.caption =
      "Frames of an animation; the faces of a row have one scale, arrows of all frames one scale and one range of "
      "colours. Arrows are thinned, with the strongest of every region among them; turns of the head are part of them.";
  plate.note = noteOf(states);
  return context.drawn(plate);
}

FigureDrawing drawTexturedAnimation(FigureContext& context) {
  const std::vector<FaceState> states = animationStates(context, frames, 0.5, 1.0);
  Plate plate;
  plate.columns = 1;
  plate.panels = {texturedRow(context, states, 0, "", true)};
  plate.caption = "Frames of an animation, textured, at one scale.";
  plate.note = noteOf(states);
  return context.drawn(plate);
}

}  // namespace mien
