#include "FAPTable.h"

namespace mien {

std::vector<int> paperSubset() {
  std::vector<int> numbers;
  for (const FAPDefinition& fap : fapTable)
    if (fap.inPaperSubset) numbers.push_back(fap.number);
  return numbers;
}

std::vector<int> fapsWithoutSurface(const std::vector<int>& faps) {
  std::vector<int> missing;
  for (int number : faps)
    if (number >= 1 && number <= FAPFrame::count && !fapDefinition(number).hasSurface) missing.push_back(number);
  return missing;
}

FAPFrame mirrored(const FAPFrame& frame) {
  FAPFrame result = frame;
  for (int number = FAPFrame::firstLowLevel; number <= FAPFrame::count; ++number) {
    const FAPDefinition& fap = fapDefinition(number);
    result.setValue(fap.mirrorPartner, fap.mirrorSign * frame.value(number));
  }
  return result;
}

}  // namespace mien
