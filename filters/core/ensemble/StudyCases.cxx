#include "StudyCases.h"

#include <algorithm>

#include "Checksum.h"
#include "NumberText.h"

namespace mien {

namespace {

/// Takes the place in the list that changes fastest off a number.
std::size_t take(std::int64_t& number, std::size_t length) {
  const auto count = static_cast<std::int64_t>(length);
  const std::int64_t place = number % count;
  number /= count;
  return static_cast<std::size_t>(place);
}

}  // namespace

StudyCases::StudyCases(const Study& study)
    : study_(study),
      smoothingCount_(static_cast<std::int64_t>(study.smoothing.size())),
      blocksPerScheme_((smoothingCount_ + longestBlock - 1) / longestBlock),
      count_(static_cast<std::int64_t>(study.caseCount())) {}

StudyCase StudyCases::at(std::int64_t number) const {
  StudyCase one;
  one.number = number;
  FaceState& state = one.state;
  state.surface.smoothing.fill(study_.smoothing[take(number, study_.smoothing.size())]);
  state.surface.scheme = study_.schemes[take(number, study_.schemes.size())];
  state.surface.modes = study_.harmonics[take(number, study_.harmonics.size())];
  state.surface.remainder = study_.remainder;
  one.pose = take(number, study_.poses.size());
  one.face = take(number, study_.faces.size());
  const StudyPose& pose = study_.poses[one.pose];
  const std::string& face = study_.faces[one.face];
  if (face != Study::genericFace) state.curvesFile = study_.pathOf(face);
  state.expressions = pose.expressions;
  if (pose.isFrame) {
    state.fapFile = study_.pathOf(study_.fapFile);
    state.frameChoice = FaceState::FrameChoice::Number;
    state.frame = pose.frame;
  }
  state.rows = study_.rows;
  state.columns = study_.columns;
  one.id = idOf(one);
  return one;
}

StudyBlock StudyCases::block(std::int64_t number) const {
  const std::int64_t scheme = number / blocksPerScheme_, part = number % blocksPerScheme_;
  const std::int64_t begin = scheme * smoothingCount_ + part * longestBlock;
  return {begin, std::min(begin + longestBlock, (scheme + 1) * smoothingCount_)};
}

std::string StudyCases::idOf(const StudyCase& one) const {
  const StudyPose& pose = study_.poses[one.pose];
  const FaceSurfaceOptions& surface = one.state.surface;
  std::string text = study_.faces[one.face] + "\n" + surface.scheme + "\n";
  for (const double number :
       {surface.smoothing[0], static_cast<double>(surface.modes), surface.remainder ? 1.0 : 0.0,
        static_cast<double>(study_.rows), static_cast<double>(study_.columns), study_.referenceSmoothing})
    text += numberText(number) + "\n";
  text += pose.isFrame ? study_.fapFile + "\n" + numberText(pose.frame) : pose.expression;
  return hashText(text);
}

}  // namespace mien
