#include "FAPList.h"

#include "FAPTable.h"

namespace mien {

std::string listOfFAPs(const std::vector<int>& faps) {
  std::string list;
  for (const int fap : faps)
    list += (list.empty() ? "" : ", ") + std::to_string(fap) + " " + std::string(fapDefinition(fap).name);
  return list;
}

}  // namespace mien
