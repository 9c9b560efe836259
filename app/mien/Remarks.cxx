#include "Remarks.h"

#include "FAPTable.h"
#include "FacePipeline.h"

#include "vtkFAPAnimationFilter.h"
#include "vtkFAPReader.h"

#include <iostream>

namespace mien {

namespace {

std::string nameList(const std::vector<int>& faps) {
  std::string names;
  for (const int fap : faps)
    names += (names.empty() ? "" : ", ") + std::to_string(fap) + " " + std::string(fapDefinition(fap).name);
  return names;
}

}  // namespace

void printRemarks(const FacePipeline& pipeline) {
  const std::string& file = pipeline.state().fapFile;
  if (!file.empty())
    for (const std::string& warning : pipeline.frames()->GetWarnings()) std::cerr << "mien: " << warning << "\n";
  const std::vector<int> ignored = pipeline.animation()->GetIgnoredFAPs();
  if (!ignored.empty())
    std::cerr << "mien: " << (file.empty() ? "" : file + ": ") << "these FAPs move nothing on this face: " << nameList(ignored)
              << "\n";
}

}  // namespace mien
