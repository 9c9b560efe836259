#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "FaceState.h"

namespace mien {

/// One movement of a face in a study: an expression or a frame of its animation; neither is the face at rest.
struct StudyPose {
  std::string expression;  ///< as written, "joy:0.6"; "neutral" for a face at rest; empty for a frame
  std::map<std::string, double> expressions;
  bool isFrame = false;
  double frame = 0.0;  ///< number as written in the animation

  bool isNeutral() const { return !isFrame && expressions.empty(); }
  bool operator==(const StudyPose& other) const;
};

/// A study: every face in every pose, with every N, in every scheme, at every a, measured. StudyText has its text form.
struct Study {
  static constexpr std::int64_t mostCases = 10'000'000;
  static constexpr std::size_t longestList = 10'000;  ///< of any member
  static constexpr const char* genericFace = "generic";
  static constexpr const char* neutral = "neutral";

  std::vector<std::string> faces = {genericFace};  ///< files of boundary curves, as written
  std::vector<std::string> schemes = {FaceSurfaceOptions().scheme};
  std::vector<double> smoothing = {1.0};  ///< the values of a, the same for all patches
  std::vector<int> harmonics = {FaceSurfaceOptions().modes};
  bool remainder = true;
  std::vector<StudyPose> poses = {{neutral, {}, false, 0.0}};
  std::string fapFile;                ///< of the poses that are frames, as written; empty: none
  bool allFrames = false;             ///< its frames are poses, all of them: see addAllFrames()
  int rows = 112, columns = 80;       ///< the grid that is measured, as a sweep's
  double referenceSmoothing = 1.0;    ///< the a that departures are measured from
  std::vector<std::string> measures;  ///< as in caseMeasureNames(), in the order of the columns

  std::string folder;  ///< where the files lie that have no path from the root; not part of the text

  Study();  ///< the generic face at rest, all measures

  /// A file's name with the folder before it where it needs one.
  std::string pathOf(const std::string& file) const;

  /// Once the animation was read: one pose for each of these numbers, if all frames are wanted. Of
  /// frames with one number the first is shown.
  void addAllFrames(const std::vector<double>& numbers);

  /// How many cases there are: exact, also beyond mostCases (a double, so that nothing overflows).
  double caseCount() const;

  bool operator==(const Study& other) const;
};

}  // namespace mien
