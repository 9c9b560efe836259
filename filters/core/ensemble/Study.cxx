#include "Study.h"

#include <set>
#include <tuple>

#include "CaseMeasures.h"

namespace mien {

bool StudyPose::operator==(const StudyPose& other) const {
  return std::tie(expression, expressions, isFrame, frame) ==
         std::tie(other.expression, other.expressions, other.isFrame, other.frame);
}

Study::Study() : measures(caseMeasureNames()) {}

std::string Study::pathOf(const std::string& file) const {
  const bool isWhole = !file.empty() && file.front() == '/';
  return folder.empty() || isWhole ? file : folder + "/" + file;
}

void Study::addAllFrames(const std::vector<double>& numbers) {
  if (!allFrames) return;
  std::set<double> known;
  for (const double number : numbers)
    if (known.insert(number).second) poses.push_back({"", {}, true, number});
  allFrames = false;
}

double Study::caseCount() const {
  double count = 1.0;
  for (const std::size_t length : {faces.size(), poses.size(), harmonics.size(), schemes.size(), smoothing.size()})
    count *= static_cast<double>(length);
  return count;
}

bool Study::operator==(const Study& other) const {
  const auto members = [](const Study& s) {
    return std::tie(s.faces, s.schemes, s.smoothing, s.harmonics, s.remainder, s.poses, s.fapFile, s.allFrames, s.rows,
                    s.columns, s.referenceSmoothing, s.measures);
  };
  return members(*this) == members(other);
}

}  // namespace mien
