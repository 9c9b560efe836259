#include "FaceLayout.h"

#include <cctype>

namespace mien {

std::string FaceLayout::curveName(int index) {
  if (index == lowerLip) return "C22'";
  return "C" + std::to_string(index < lowerLip ? index + 1 : index);
}

int FaceLayout::curveId(int index) {
  if (index == lowerLip) return curveCount;
  return index < lowerLip ? index + 1 : index;
}

int FaceLayout::curveIndex(const std::string& name) {
  std::string wanted = name;
  if (!wanted.empty()) wanted[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(wanted[0])));
  if (wanted == "C22p") wanted = "C22'";
  for (int index = 0; index < curveCount; ++index)
    if (curveName(index) == wanted) return index;
  return -1;
}

}  // namespace mien
