#include "CaptureWriter.h"

#include <algorithm>
#include <cmath>

#include "ActionFit.h"
#include "FAPWriter.h"
#include "NumberText.h"
#include "TimeCode.h"

namespace mien {

namespace {

constexpr double intensityOfOpenFace = 5.0;
// The action units that OpenFace estimates; 28 as a presence only.
constexpr int openFaceUnits[] = {1, 2, 4, 5, 6, 7, 9, 10, 12, 14, 15, 17, 20, 23, 25, 26, 45, 28};
constexpr double presentFrom = 0.2;  // of full strength: the first of the five intensities of FACS

std::string numbered(int unit) {
  return (unit < 10 ? "AU0" : "AU") + std::to_string(unit);
}

/// Actions that are columns: their names in the file and a factor on their strengths.
struct Columns {
  std::vector<CaptureAction> actions;
  std::vector<std::string> names;
  std::vector<CaptureAction> angles;  ///< of one FAP each, or none; written as they are
  double factor = 1.0;

  void add(const CaptureAction& action, const std::string& name) {
    actions.push_back(action);
    names.push_back(name);
  }
};

/// Two names for one movement would share its strength.
bool isRepeated(const CaptureAction& action, const std::vector<CaptureAction>& actions) {
  return std::any_of(actions.begin(), actions.end(),
                     [&](const CaptureAction& other) { return other.faps == action.faps; });
}

Columns columnsOfFACS(const FacialActionMap& map) {
  Columns columns;
  std::vector<CaptureAction> written;
  for (const CaptureAction& action : map.actionUnits) {
    if (isRepeated(action, written)) continue;
    written.push_back(action);
    if (!action.sided) columns.add(action, action.name);
    for (const bool left : {true, false})
      if (action.sided) columns.add(sideOf(action, left), action.name + (left ? "L" : "R"));
  }
  return columns;
}

Columns columnsOfOpenFace(const FacialActionMap& map) {
  Columns columns;
  for (const int unit : openFaceUnits)
    if (const CaptureAction* action = findAction(map.actionUnits, "AU" + std::to_string(unit)))
      columns.add(*action, numbered(unit) + (unit == 28 ? "_c" : "_r"));
  for (const CaptureAction& rotation : map.rotations)
    if (rotation.name.compare(0, 5, "pose_") == 0) columns.angles.push_back(rotation);
  columns.factor = intensityOfOpenFace;
  return columns;
}

Columns columnsOfLiveLink(const FacialActionMap& map) {
  Columns columns;
  for (const CaptureAction& shape : map.blendshapes) {
    std::string name = shape.name;
    if (name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
    columns.add(shape, name);
  }
  for (const CaptureAction& rotation : map.rotations)
    if (rotation.name.compare(0, 5, "pose_") != 0) columns.angles.push_back(rotation);
  return columns;
}

Columns columnsOf(CaptureStyle style, const FacialActionMap& map) {
  if (style == CaptureStyle::FACS) return columnsOfFACS(map);
  return style == CaptureStyle::OpenFace ? columnsOfOpenFace(map) : columnsOfLiveLink(map);
}

std::string headerOf(CaptureStyle style, const Columns& columns) {
  std::string names, angles;
  for (const std::string& name : columns.names) names += "," + name;
  for (const CaptureAction& angle : columns.angles) angles += "," + angle.name;
  if (style == CaptureStyle::FACS) return "frame,time" + names + "\n";
  if (style == CaptureStyle::OpenFace) return "frame,timestamp,confidence,success" + angles + names + "\n";
  return "Timecode,BlendshapeCount" + names + angles + "\n";
}

/// Four digits after the point are what capture apps write, and finer than any of them measures.
void appendStrength(double value, std::string& text) {
  appendNumber(text += ",", std::round(value * 1e4) / 1e4);
}

void appendAngles(const FAPFrame& frame, const Columns& columns, std::string& text) {
  for (const CaptureAction& angle : columns.angles) {
    double radians = 0.0;
    for (const auto& [fap, value] : angle.faps) radians = frame.value(fap) / value;
    appendNumber(text += ",", std::round(radians * 1e6) / 1e6 + 0.0);
  }
}

void appendStrengths(const Eigen::VectorXd& strengths, const Columns& columns, std::string& text) {
  for (Eigen::Index i = 0; i < strengths.size(); ++i) {
    const bool presence = columns.names[static_cast<std::size_t>(i)].find("_c") != std::string::npos;
    appendStrength(presence ? (strengths(i) >= presentFrom ? 1.0 : 0.0) : strengths(i) * columns.factor, text);
  }
}

std::string rowOf(CaptureStyle style, const FAPSequence& sequence, std::size_t index, const Columns& columns,
                  const Eigen::VectorXd& strengths) {
  const FAPFrame& frame = sequence.frames[index];
  const double time = sequence.timeOfFrame(index);
  std::string text;
  if (style == CaptureStyle::LiveLinkFace) {
    text = timeCodeText(sequence.startTime + time) + "," + std::to_string(columns.names.size() + columns.angles.size());
    appendStrengths(strengths, columns, text);
    appendAngles(frame, columns, text);
    return text + "\n";
  }
  appendNumber(text, frame.number);
  appendNumber(text += ",", time);
  if (style == CaptureStyle::OpenFace) text += ",1,1";
  appendAngles(frame, columns, text);
  appendStrengths(strengths, columns, text);
  return text + "\n";
}

bool isAngle(int fap, const Columns& columns) {
  return std::any_of(columns.angles.begin(), columns.angles.end(), [fap](const CaptureAction& angle) {
    return !angle.faps.empty() && angle.faps.front().first == fap;
  });
}

}  // namespace

std::string writeCapture(const FAPSequence& sequence, CaptureStyle style, const FacialActionMap& map, std::string& text,
                         CaptureLoss& loss) {
  const std::string fault = describeUnwritable(sequence);
  if (!fault.empty()) return fault;
  const Columns columns = columnsOf(style, map);
  FAPMask used;
  for (const int fap : sequence.fapsUsed()) used.set(fap - 1);
  const ActionFit fit(columns.actions, used);
  std::string written = headerOf(style, columns);
  CaptureLoss lost;
  double moved = 0.0, missed = 0.0, worst = 0.0;
  for (const int fap : sequence.fapsUsed())
    if (!fit.moves(fap) && !isAngle(fap, columns)) lost.faps.push_back(fap);
  for (std::size_t index = 0; index < sequence.frames.size(); ++index) {
    const Eigen::VectorXd strengths = fit.solve(sequence.frames[index]);
    written += rowOf(style, sequence, index, columns, strengths);
    const double loss = fit.loss(sequence.frames[index], strengths);
    moved += fit.movement(sequence.frames[index]);
    missed += loss;
    if (loss > worst) lost.worstFrame = sequence.frames[index].number;
    worst = std::max(worst, loss);
  }
  lost.share = moved > 0.0 ? std::sqrt(missed / moved) : 0.0;
  text = std::move(written);
  loss = std::move(lost);
  return {};
}

}  // namespace mien
