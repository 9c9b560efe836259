#include "FrameName.h"

namespace mien {

bool isNumberedByFrame(const std::string& name) {
  return name.find(framePlaceholder) != std::string::npos;
}

std::string nameForFrame(std::string name, const std::string& frame) {
  for (size_t at = name.find(framePlaceholder); at != std::string::npos;
       at = name.find(framePlaceholder, at + frame.size()))
    name.replace(at, framePlaceholder.size(), frame);
  return name;
}

}  // namespace mien
