#include "Remarks.h"

#include <cmath>
#include <iostream>

#include "AnimationTextFile.h"
#include "FAPList.h"
#include "FacePipeline.h"
#include "vtkFAPAnimationFilter.h"
#include "vtkFAPReader.h"

namespace mien {

namespace {

constexpr double visiblePush = 0.5;  ///< mm; less is what curves near a moving lip or lid do in any lively face

}  // namespace

void printRemarks(const FacePipeline& pipeline) {
  const std::string file = shownAnimationName(pipeline.state().fapFile);
  if (!file.empty())
    for (const std::string& warning : pipeline.frames()->GetWarnings()) std::cerr << "mien: " << warning << "\n";
  const std::vector<int> ignored = pipeline.animation()->GetIgnoredFAPs();
  if (!ignored.empty())
    std::cerr << "mien: " << (file.empty() ? "" : file + ": ")
              << "these FAPs move nothing on this face: " << listOfFAPs(ignored) << "\n";
  const double pushed = pipeline.animation()->GetLargestPushed();
  if (pushed >= visiblePush)
    std::cerr << "mien: " << (file.empty() ? "" : file + ": ")
              << "curves without room for these FAPs gave way by up to " << std::round(pushed * 10.0) / 10.0
              << " mm; smaller values leave every curve its way\n";
}

}  // namespace mien
